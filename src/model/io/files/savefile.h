// Saves files atomically: a failure leaves the existing file unchanged.
#pragma once

#include "model/document/result.h"

#include <QByteArrayView>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace autocuts {

class SetJournal;

//! Files that belong together, such as the pictures of a bake. Each is written to a temporary file beside its
//! target; then all of them replace their targets. After an error, and when the set is deleted before that,
//! all targets are as they were and no temporary file is left. Where the file system has files without a name
//! (most of Linux), a killed program leaves none either, unless it is killed while the targets are replaced:
//! then a SetJournal lets the next program that looks into the folder make all of them new, or leave all as
//! they were. Of a single file NAME.XXXXXX may be left.
class FileSet
{
public:
    FileSet();
    ~FileSet();
    FileSet(const FileSet &) = delete;
    FileSet &operator=(const FileSet &) = delete;

    //! Writes the bytes to disk. The target is what a symbolic link leads to. Errors: missing folder, no
    //! permission, not a regular file, disk full. Of bytes for the same target the last ones count.
    Result<Done> add(const QString &path, QByteArrayView bytes);
    //! Replaces the targets in the order of add(). When that fails for one of them, those before it get back
    //! what they were. Where the file system has no hard links they cannot, and the Error names them.
    Result<Done> putInPlace();
    //! The paths in the order of add().
    QStringList paths() const;

private:
    struct Pending;
    Result<Done> prepare(const SetJournal &journal);
    Error undo(std::size_t replaced, Error error);

    std::vector<Pending> mFiles;
};

//! An Error that FileSet::add() would give before it writes anything.
Result<Done> checkTarget(const QString &path);

//! Writes a single file as a FileSet does: on any error an existing file keeps its content.
//! \param beforeReplacing called when the bytes are safely on disk and the old file is still in place
Result<Done> saveAtomically(const QString &path, QByteArrayView bytes,
                            const std::function<void()> &beforeReplacing = {});

//! The bytes of a regular file, or an Error that says why it cannot be read: it is missing, a folder, a
//! device, not readable, or larger than `limit` bytes.
Result<QByteArray> loadFile(const QString &path, qint64 limit);

//! What a reader says that was told to stop.
Error readingCancelled(const QString &path);

} // namespace autocuts
