#include "model/io/savefile.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include <cerrno>
#ifdef Q_OS_UNIX
#include <unistd.h>
#endif

namespace autocuts {

namespace {

struct ErrorTexts
{
    Q_DECLARE_TR_FUNCTIONS(FileErrors)
};

//! Forces delayed writes, so that an error such as a full disk is noticed. QSaveFile also syncs but ignores
//! the result.
bool reachesDisk([[maybe_unused]] int handle)
{
#ifdef Q_OS_UNIX
    // Some file systems cannot sync (EINVAL, EROFS); only lost data is an error.
    return fsync(handle) == 0 || (errno != EIO && errno != ENOSPC && errno != EDQUOT);
#else
    return true;
#endif
}

//! \param systemError errno after the step that failed
Error writeError(const QString &path, const QSaveFile &file, int systemError)
{
#ifdef Q_OS_UNIX
    if (systemError == ENOSPC || systemError == EDQUOT)
        return {ErrorTexts::tr("there is no space left on the disk"), path, 0,
                ErrorTexts::tr("Free some space, or choose another folder")};
#endif
    const QString reason =
        file.error() == QFileDevice::NoError ? qt_error_string(systemError) : file.errorString();
    return {ErrorTexts::tr("the file cannot be written (%1)").arg(reason), path, 0,
            ErrorTexts::tr("Check the permissions and the free space of the folder, or choose another one")};
}

} // namespace

Result<Done> saveAtomically(const QString &path, QByteArrayView bytes,
                            const std::function<void()> &beforeReplacing)
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

    QSaveFile file(path);
    errno = 0;
    if (!file.open(QIODevice::WriteOnly))
        return writeError(path, file, errno);
    // flush() is called here because commit() does not notice when its own flush fails.
    const bool written = file.write(bytes.data(), bytes.size()) == bytes.size() && file.flush();
    if (!written || !reachesDisk(file.handle())) {
        const Error error = writeError(path, file, errno);
        file.cancelWriting();
        file.commit();
        return error;
    }
    if (beforeReplacing)
        beforeReplacing();
    if (!file.commit())
        return writeError(path, file, errno);
    return Done{};
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
