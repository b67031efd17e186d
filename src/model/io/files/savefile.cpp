#include "model/io/files/savefile.h"

#include "model/io/files/filecalls.h"
#include "model/io/files/setjournal.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QTemporaryFile>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <system_error>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

struct ErrorTexts
{
    Q_DECLARE_TR_FUNCTIONS(FileErrors)
};

//! \param systemError errno after the step that failed
Error writeError(const QString &path, int systemError, const QString &reason)
{
    if (filecalls::isOutOfSpace(systemError))
        return {ErrorTexts::tr("there is no space left on the disk"), path, 0,
                ErrorTexts::tr("Free some space, or choose another folder")};
    return {ErrorTexts::tr("the file cannot be written (%1)").arg(reason), path, 0,
            ErrorTexts::tr("Check the permissions and the free space of the folder, or choose another one")};
}

Error writeError(const QString &path, const QFile &file, int systemError)
{
    return writeError(path, systemError,
                      file.error() == QFileDevice::NoError ? qt_error_string(systemError)
                                                           : file.errorString());
}

Error writeError(const QString &path, const std::error_code &problem)
{
    return writeError(path, problem.value(), QString::fromStdString(problem.message()));
}

//! The path that a chain of symbolic links leads to.
QString withoutLinks(QString path)
{
    constexpr int most = 40; // as Linux allows
    for (int i = 0; i < most && QFileInfo(path).isSymLink(); ++i)
        path = QFileInfo(path).symLinkTarget();
    return path;
}

std::filesystem::path native(const QString &path)
{
    return path.toStdU16String();
}

//! Gives a temporary file, which only its owner may read, the permissions of the file it replaces, or those
//! of a new file.
void setUsualPermissions(QFile &file, const QFileInfo &target)
{
    if (target.exists())
        file.setPermissions(target.permissions());
    else
        filecalls::setPermissionsOfNewFile(file);
}

} // namespace

Result<Done> checkTarget(const QString &path)
{
    const QFileInfo target(path);
    if (path.isEmpty() || target.isDir())
        return Error{ErrorTexts::tr("this is a folder, not a file"), path, 0,
                     ErrorTexts::tr("Add a file name to the path")};
    if (target.exists() && !target.isFile())
        return Error{ErrorTexts::tr("this is not a regular file and cannot be replaced"), path, 0,
                     ErrorTexts::tr("Choose another file name")};
    if (!target.absoluteDir().exists())
        return Error{ErrorTexts::tr("the folder %1 does not exist").arg(target.absolutePath()), path, 0,
                     ErrorTexts::tr("Create the folder or choose another one")};
    // Renaming would replace it, because that asks for the permissions of the folder only.
    if (target.exists() && !target.isWritable())
        return Error{ErrorTexts::tr("the file is write-protected"), path, 0,
                     ErrorTexts::tr("Check its permissions, or choose another file name")};
    return Done{};
}

struct FileSet::Pending
{
    QString path;   //!< for messages
    QString target; //!< without links
    std::unique_ptr<QTemporaryFile> file;
    QString written; //!< name of the temporary file, once it has one
    QString backup;  //!< hard link to the old file; empty where there is none
    bool isNew = false;
};

FileSet::FileSet() = default;

FileSet::~FileSet() = default;

Result<Done> FileSet::add(const QString &path, QByteArrayView bytes)
{
    if (Result<Done> fine = checkTarget(path); !fine)
        return fine;
    if (!mFiles.empty())
        filecalls::allowManyFiles(); // every file of a set is open until it is in its place
    const QFileInfo target(withoutLinks(path));
    auto file = std::make_unique<QTemporaryFile>(target.absoluteFilePath() + u".XXXXXX"_s);
    errno = 0;
    if (!file->open())
        return writeError(path, *file, errno);
    // QFile does not notice when the flush of its own close fails.
    const bool written = file->write(bytes.data(), bytes.size()) == bytes.size() && file->flush();
    if (!written || !filecalls::reachesDisk(*file))
        return writeError(path, *file, errno);
    setUsualPermissions(*file, target);
    Pending pending{path, target.absoluteFilePath(), std::move(file), {}, {}, false};
    const auto again = std::ranges::find(mFiles, pending.target, &Pending::target);
    if (again == mFiles.end())
        mFiles.push_back(std::move(pending));
    else
        *again = std::move(pending);
    return Done{};
}

//! Gives the new files names beside their targets, and the old ones second names.
Result<Done> FileSet::prepare(const SetJournal &journal)
{
    for (Pending &pending : mFiles) {
        errno = 0;
        if (mFiles.size() == 1)
            pending.written = pending.file->fileName(); // a file without a name gets one here
        else if (pending.written = journal.newName(pending.target); !pending.file->rename(pending.written))
            pending.written.clear();
        if (!QFileInfo::exists(pending.written))
            return writeError(pending.path, *pending.file, errno);
        pending.isNew = !QFileInfo::exists(pending.target);
        if (pending.isNew || &pending == &mFiles.back()) // nothing can fail after the last one
            continue;
        const QString backup = journal.oldName(pending.target);
        std::error_code problem;
        std::filesystem::create_hard_link(native(pending.target), native(backup), problem);
        if (!problem)
            pending.backup = backup;
    }
    return Done{};
}

Result<Done> FileSet::putInPlace()
{
    SetJournal journal;
    if (mFiles.size() > 1) {
        QStringList targets;
        for (const Pending &pending : mFiles)
            targets << pending.target;
        if (const int error = journal.begin(targets))
            return writeError(mFiles.front().path, error, qt_error_string(error));
    }
    if (const Result<Done> prepared = prepare(journal); !prepared)
        return undo(0, prepared.error());
    std::error_code problem;
    for (std::size_t i = 0; i < mFiles.size(); ++i) {
        std::filesystem::rename(native(mFiles[i].written), native(mFiles[i].target), problem);
        if (problem)
            return undo(i, writeError(mFiles[i].path, problem));
        mFiles[i].file->setAutoRemove(false);
    }
    for (const Pending &pending : mFiles) {
        if (!pending.backup.isEmpty())
            std::filesystem::remove(native(pending.backup), problem);
    }
    return Done{};
}

//! Puts the old files back. \param replaced how many targets have been replaced already
Error FileSet::undo(std::size_t replaced, Error error)
{
    QStringList changed;
    std::error_code problem;
    for (std::size_t i = 0; i < mFiles.size(); ++i) {
        Pending &pending = mFiles[i];
        problem.clear();
        if (!pending.backup.isEmpty() && i < replaced)
            std::filesystem::rename(native(pending.backup), native(pending.target), problem);
        else if (!pending.backup.isEmpty())
            std::filesystem::remove(native(pending.backup), problem);
        else if (i < replaced && pending.isNew)
            std::filesystem::remove(native(pending.target), problem);
        if (i < replaced && (problem || (pending.backup.isEmpty() && !pending.isNew)))
            changed << QFileInfo(pending.path).fileName();
        if (i >= replaced)
            pending.file->remove();
    }
    if (!changed.isEmpty())
        error.message += ErrorTexts::tr("; these files are replaced already: %1").arg(changed.join(u", "_s));
    return error;
}

QStringList FileSet::paths() const
{
    QStringList paths;
    for (const Pending &pending : mFiles)
        paths << pending.path;
    return paths;
}

Result<Done> saveAtomically(const QString &path, QByteArrayView bytes,
                            const std::function<void()> &beforeReplacing)
{
    FileSet files;
    if (Result<Done> added = files.add(path, bytes); !added)
        return added;
    if (beforeReplacing)
        beforeReplacing();
    return files.putInPlace();
}

Result<QByteArray> loadFile(const QString &path, qint64 limit)
{
    const QFileInfo info(path);
    if (!info.exists())
        return Error{ErrorTexts::tr("there is no such file"), path, 0, ErrorTexts::tr("Check the path")};
    if (info.isDir())
        return Error{ErrorTexts::tr("this is a folder, not a file"), path, 0,
                     ErrorTexts::tr("Name a file in it")};
    if (!info.isFile())
        return Error{ErrorTexts::tr("this is not a regular file"), path, 0,
                     ErrorTexts::tr("Copy its content to a file first")};
    if (info.size() > limit)
        return Error{ErrorTexts::tr("the file has %1 bytes, the limit is %2").arg(info.size()).arg(limit),
                     path, 0, ErrorTexts::tr("Split the model into several files")};
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{ErrorTexts::tr("the file cannot be read (%1)").arg(file.errorString()), path, 0,
                     ErrorTexts::tr("Check its permissions")};
    QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError || bytes.size() < info.size())
        return Error{ErrorTexts::tr("reading the file failed (%1)").arg(file.errorString()), path, 0,
                     ErrorTexts::tr("Check the disk and try again")};
    return bytes;
}

Error readingCancelled(const QString &path)
{
    return {ErrorTexts::tr("reading was cancelled"), path, 0, {}};
}

} // namespace autocuts
