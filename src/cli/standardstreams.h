// Models that come by standard input and go to standard output.
#pragma once

#include "cli/clioptions.h"
#include "model/document/result.h"

#include <QTemporaryDir>

#include <optional>

namespace autocuts {

//! Lets commands use standard input and output: temporary files take the place of "-", because readers and
//! writers of models need a file with a suffix.
class StandardStreams final
{
public:
    //! Reads standard input when it is the input, and replaces each "-" of the options by a file.
    Result<Done> take(CliOptions &options);
    //! True when there are temporary files, which the end of this removes.
    bool areUsed() const { return mFolder.has_value(); }
    //! True when the output or the report is for standard output, which then takes nothing else.
    bool hasOutput() const { return !mOutput.isEmpty(); }
    //! Writes the output to standard output, if it goes there. \param isMade false: the output may be missing
    Result<Done> give(bool isMade) const;
    //! A text for the user or a report, with the names of the streams in place of those of the files.
    QString named(QString text) const;

private:
    QString fileFor(const QString &name);

    std::optional<QTemporaryDir> mFolder;
    QString mInput, mOutput; //!< the files; empty where "-" was not given
};

} // namespace autocuts
