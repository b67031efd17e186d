// The files of a batch: which ones are read, and what is written of each.
#pragma once

#include "cli/manychoice.h"
#include "model/document/result.h"

#include <QDateTime>

#include <vector>

namespace autocuts::manyfiles {

//! A file to work on.
struct FileTask
{
    QString input;
    QString output; //!< path below the folder of the batch; for commands that make several files, a folder
    qint64 bytes = 0;
    QDateTime modified;
};

//! Finds the files that the inputs name: files, all models in a folder and below it, or those that match a
//! pattern with *, ? or [...], and ** for any number of folders. What is below a folder or the part of a
//! pattern without wildcards is below the folder of the batch in the same place. What is in that folder
//! already counts only where it is named itself. \param folder of the batch; empty: there are no outputs
//! \returns each file once, by name; an Error where there is none, or two files would have one output
Result<std::vector<FileTask>> fileTasks(const ManyChoice &choice, const QString &folder);

//! True for a path that has the suffix of a model.
bool isModelName(const QString &path);

//! Makes a path match what it names by * (within a folder), ** (any folders), ? and [...].
bool matchesPattern(const QString &path, const QString &pattern);

} // namespace autocuts::manyfiles
