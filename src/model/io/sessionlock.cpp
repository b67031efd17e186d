#include "model/io/sessionlock.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLockFile>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

namespace autocuts {

FileStamp FileStamp::of(const QString &path)
{
    FileStamp stamp;
#ifdef Q_OS_UNIX
    struct stat status = {};
    if (stat(QFile::encodeName(path).constData(), &status) == 0)
        stamp = {qint64(status.st_size),
                 status.st_mtim.tv_sec * qint64(1'000'000'000) + status.st_mtim.tv_nsec,
                 quint64(status.st_dev), quint64(status.st_ino)};
#else
    if (const QFileInfo info(path); info.exists())
        stamp = {info.size(), info.lastModified().toMSecsSinceEpoch() * 1'000'000, 0, 0};
#endif
    return stamp;
}

SessionLock::SessionLock(const QString &session)
{
    const QFileInfo info(session);
    auto file = std::make_unique<QLockFile>(
        info.dir().filePath(QLatin1Char('.') + info.fileName() + QStringLiteral(".lock")));
    file->setStaleLockTime(0); // a session may be open for days
    if (file->tryLock(0)) {
        mFile = std::move(file);
        return;
    }
    qint64 process = 0;
    QString host, program;
    if (file->error() == QLockFile::LockFailedError && file->getLockInfo(&process, &host, &program) &&
        process != QCoreApplication::applicationPid())
        mHolder = QCoreApplication::translate("SessionLock", "%1 on %2 (process %3)")
                      .arg(program, host)
                      .arg(process);
}

SessionLock::~SessionLock() = default;

} // namespace autocuts
