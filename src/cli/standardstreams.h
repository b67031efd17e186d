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
    //! True when the output or the report is for standard output, which then takes nothing else.
    bool hasOutput() const { return !mOutput.isEmpty(); }
    //! Writes what is for standard output there, if there is something. \param isMade there must be
    Result<Done> give(bool isMade) const;
    //! A text for the user or a report, with the names of the streams in place of those of the files.
    QString named(QString text) const;

private:
    QTemporaryDir mFolder;
    QString mInput, mOutput; //!< the files; empty where "-" was not given
};

} // namespace autocuts
