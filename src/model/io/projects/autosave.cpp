#include "model/io/projects/autosave.h"

#include "model/io/projects/projectfile.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QUuid>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

struct RecoveryTexts
{
    Q_DECLARE_TR_FUNCTIONS(FileErrors)
};

//! A lock file that names no process, left by a crash while it was written, is removed after this time.
//! Chosen by hand.
constexpr int unreadableLockSeconds = 10;

QString lockPathOf(const QString &file)
{
    return file.chopped(QFileInfo(file).suffix().size()) + u"lock"_s;
}

QString leftoversOf(const QString &lockPath)
{
    return QFileInfo(lockPath).completeBaseName() + u".acproj*"_s;
}

//! Takes a lock; null when a running process holds it. QLockFile itself checks whether the process in the
//! lock still runs and is this program. The age of a lock means nothing, since sessions may last for days.
std::unique_ptr<QLockFile> tryLock(const QString &path)
{
    auto lock = std::make_unique<QLockFile>(path);
    lock->setStaleLockTime(0);
    if (lock->tryLock(0))
        return lock;
    qint64 process = 0;
    QString host, program;
    const QDateTime age = QFileInfo(path).lastModified();
    if (lock->error() == QLockFile::LockFailedError && !lock->getLockInfo(&process, &host, &program) &&
        age.isValid() && age.secsTo(QDateTime::currentDateTime()) > unreadableLockSeconds &&
        QFile::remove(path) && lock->tryLock(0))
        return lock;
    return nullptr;
}

//! Removes all files of a session except its lock. \pre the lock is held
void removeFiles(const QString &folder, const QString &lockPath, bool keepSession)
{
    QDir dir(folder);
    for (const QString &name : dir.entryList({leftoversOf(lockPath)}, QDir::Files | QDir::Hidden)) {
        if (!keepSession || !isProjectPath(name))
            dir.remove(name);
    }
}

} // namespace

std::vector<RecoverableSession> recoverableSessions(const QString &folder)
{
    const QDir dir(folder);
    QStringList bases;
    for (const QFileInfo &info : dir.entryInfoList({u"*.lock"_s, u"*.acproj*"_s}, QDir::Files | QDir::Hidden))
        bases << info.fileName().section(u'.', 0, 0);
    bases.removeDuplicates();
    std::vector<RecoverableSession> sessions;
    for (const QString &base : std::as_const(bases)) {
        const QString lockPath = dir.filePath(base + u".lock"_s);
        const std::unique_ptr<QLockFile> lock = tryLock(lockPath);
        if (!lock)
            continue;
        removeFiles(folder, lockPath, true);
        const QFileInfo file(dir.filePath(base + u".acproj"_s));
        const Result<ProjectSummary> summary = loadProjectSummary(file.filePath());
        if (summary)
            sessions.push_back(
                {file.filePath(), summary->sessionPath, summary->modelPath, file.lastModified()});
    }
    std::stable_sort(sessions.begin(), sessions.end(),
                     [](const auto &a, const auto &b) { return a.savedAt > b.savedAt; });
    return sessions;
}

void discardSession(const RecoverableSession &session)
{
    const QString lockPath = lockPathOf(session.file);
    if (const std::unique_ptr<QLockFile> lock = tryLock(lockPath))
        removeFiles(QFileInfo(session.file).path(), lockPath, false);
}

Result<std::unique_ptr<Autosave>> Autosave::start(const QString &folder, Save save,
                                                  const RecoverableSession *continued)
{
    if (!QDir().mkpath(folder))
        return Error{RecoveryTexts::tr("the folder for recovery cannot be made"), folder, 0,
                     RecoveryTexts::tr("Check the permissions of the folders above it")};
    const QString file =
        continued ? continued->file
                  : QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + u".acproj"_s);
    std::unique_ptr<QLockFile> lock = tryLock(lockPathOf(file));
    if (!lock)
        return Error{continued ? RecoveryTexts::tr("another program has this session open")
                               : RecoveryTexts::tr("the folder for recovery cannot be written"),
                     file, 0,
                     continued ? RecoveryTexts::tr("Go on there")
                               : RecoveryTexts::tr("Check the permissions and the free space of the folder")};
    return std::unique_ptr<Autosave>(new Autosave(file, std::move(lock), std::move(save)));
}

Autosave::Autosave(QString file, std::unique_ptr<QLockFile> lock, Save save)
    : mFile(std::move(file)), mLock(std::move(lock)), mSave(std::move(save))
{
    for (QTimer *timer : {&mLatest, &mRest}) {
        timer->setSingleShot(true);
        connect(timer, &QTimer::timeout, this, &Autosave::saveNow);
    }
}

Autosave::~Autosave()
{
    sessionSaved();
}

void Autosave::setInterval(int milliseconds)
{
    mInterval = milliseconds;
    if (mLatest.isActive() && mLatest.remainingTime() > mInterval)
        mLatest.start(mInterval);
}

void Autosave::sessionChanged()
{
    if (!mLatest.isActive())
        mLatest.start(mInterval);
    mRest.start(std::min(restInterval, mInterval));
}

void Autosave::saveSoon()
{
    mRest.start(0);
}

void Autosave::sessionSaved()
{
    mLatest.stop();
    mRest.stop();
    mUnwanted = mSaving > 0;
    removeFiles(QFileInfo(mFile).path(), lockPathOf(mFile), false);
}

void Autosave::saveNow()
{
    mLatest.stop();
    mRest.stop();
    mUnwanted = false;
    ++mSaving;
    mSave(mFile, [self = QPointer(this)](const Result<Done> &saved) {
        if (self)
            self->saveEnded(saved);
    });
}

void Autosave::saveEnded(const Result<Done> &saved)
{
    --mSaving;
    if (mUnwanted) {
        removeFiles(QFileInfo(mFile).path(), lockPathOf(mFile), false);
        mUnwanted = mSaving > 0;
    } else if (!saved) {
        mLatest.start(mInterval);
        Q_EMIT failed(saved.error());
    }
}

} // namespace autocuts
