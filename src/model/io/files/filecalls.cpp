#include "model/io/files/filecalls.h"

#include <QDateTime>
#include <QFileInfo>

#include <cerrno>
#ifdef Q_OS_UNIX
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace autocuts {

#ifdef Q_OS_UNIX

FileStamp FileStamp::of(const QString &path)
{
    struct stat status = {};
    if (stat(QFile::encodeName(path).constData(), &status) != 0)
        return {};
    return {qint64(status.st_size), status.st_mtim.tv_sec * qint64(1'000'000'000) + status.st_mtim.tv_nsec,
            quint64(status.st_dev), quint64(status.st_ino)};
}

namespace filecalls {

namespace {

//! The permissions that new files do not get. It can be read only by changing it, so that is done before
//! there are threads.
const mode_t createMask = [] {
    const mode_t mask = umask(S_IWGRP | S_IWOTH);
    umask(mask);
    return mask;
}();

} // namespace

bool reachesDisk(const QFile &file)
{
    // Some file systems cannot sync (EINVAL, EROFS); only lost data is an error.
    return fsync(file.handle()) == 0 || (errno != EIO && !isOutOfSpace(errno));
}

bool isOutOfSpace(int systemError)
{
    return systemError == ENOSPC || systemError == EDQUOT;
}

bool lockUntilClosed(const QFile &file)
{
    return flock(file.handle(), LOCK_EX | LOCK_NB) == 0;
}

bool belongsToUser(const QFile &file)
{
    return QFileInfo(file).ownerId() == geteuid();
}

void allowManyFiles()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur < limit.rlim_max) {
        limit.rlim_cur = limit.rlim_max;
        setrlimit(RLIMIT_NOFILE, &limit);
    }
}

void setPermissionsOfNewFile(const QFile &file)
{
    constexpr mode_t all = S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
    fchmod(file.handle(), all & ~createMask);
}

} // namespace filecalls

#else

FileStamp FileStamp::of(const QString &path)
{
    const QFileInfo info(path);
    if (!info.exists())
        return {};
    // Without the number of a file, its path stands for it.
    return {info.size(), info.lastModified().toMSecsSinceEpoch() * 1'000'000, 0,
            quint64(qHash(info.canonicalFilePath()))};
}

namespace filecalls {

bool reachesDisk(const QFile &)
{
    return true;
}

bool isOutOfSpace(int systemError)
{
    return systemError == ENOSPC;
}

bool lockUntilClosed(const QFile &)
{
    return true;
}

bool belongsToUser(const QFile &)
{
    return true;
}

void allowManyFiles() {}

void setPermissionsOfNewFile(const QFile &) {}

} // namespace filecalls

#endif

} // namespace autocuts
