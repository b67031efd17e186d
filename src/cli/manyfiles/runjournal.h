// The journal of a batch: what has been done with which file, so that it can go on after a kill.
#pragma once

#include "cli/manyfiles/filelist.h"

#include <QFile>
#include <QJsonObject>
#include <QLockFile>

#include <map>
#include <memory>

namespace autocuts::manyfiles {

//! What came of a file.
struct FileResult
{
    FileTask task;
    QString
        status; //!< "done", "bound_missed", "time_limit", "check_failed", "failed", "crashed" or "timed_out"
    QString message; //!< why it failed
    QStringList warnings;
    QJsonObject figures; //!< the numbers of the report
    double seconds = 0;

    //! True when there is an output.
    bool succeeded() const;
    QJsonObject toJson() const;
    static FileResult fromJson(const QJsonObject &line);
    //! True when the line is about this file as it is now.
    bool isOf(const FileTask &other) const;
};

//! The results by output.
using FileResults = std::map<QString, FileResult>;

//! A file of lines of JSON in the folder of a batch. The first says what is done, each further one what came
//! of one file. A line counts when it is complete and on disk, which is after the output of its file.
class RunJournal final
{
public:
    //! The journal of all files, or of the part that is chosen.
    RunJournal(const ManyChoice &choice, const QString &folder);

    //! Begins a new one; the one before is kept for comparison, those of the parts are not.
    Result<Done> begin(const ManyChoice &choice);
    //! Reads what there is, and goes on behind it; begins a new one where there is none. An Error when it is
    //! that of another command, or of other options.
    Result<FileResults> resume(const ManyChoice &choice);
    //! Adds a line and waits until it is on disk.
    Result<Done> add(const FileResult &result);
    //! The results of the run before.
    FileResults before() const;
    //! What the journals of the parts say that were done with the same command and options.
    FileResults ofParts(const ManyChoice &choice) const;
    //! The name of the journal without its suffix.
    static QString nameFor(const ManyChoice &choice);

    //! Locks the journal. An Error when another batch has it, or works on the same files: all of them while
    //! this is a part, or another division into parts.
    static Result<std::unique_ptr<QLockFile>> lock(const ManyChoice &choice, const QString &folder);

private:
    QStringList partPaths() const;
    Result<Done> writeHead(const ManyChoice &choice);

    QString mFolder, mPath, mBefore;
    QFile mFile;
};

} // namespace autocuts::manyfiles
