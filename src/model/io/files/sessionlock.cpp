#include "model/io/files/sessionlock.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLockFile>

namespace autocuts {

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
