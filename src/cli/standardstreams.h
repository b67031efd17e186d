// Models that come by standard input and go to standard output.
#pragma once

#include "cli/clioptions.h"
#include "model/document/result.h"

#include <QTemporaryDir>

namespace autocuts {

//! Puts files into the place of "-": readers and writers of models need a file with a suffix.
class StandardStreams final
{
public:
    //! Reads standard input where the options name it as the input, and names files in place of "-".
    Result<Done> take(CliOptions &options);
    //! True when the output is for standard output, which then takes nothing else.
    bool hasOutput() const { return !mOutput.isEmpty(); }
    //! Writes the output to standard output, if there is one.
    Result<Done> give() const;

private:
    QTemporaryDir mFolder;
    QString mOutput;
};

} // namespace autocuts
