#include "views/control/sessionsaver.h"

#include "model/io/fileclashes.h"

#include <QBuffer>
#include <QCoreApplication>

#include <exception>
#include <new>

namespace autocuts {

namespace {

Result<SavedProject> write(ProjectWriter &writer, const SessionToSave &session, const QString &path)
{
    if (const Result<Done> fine = checkOutputs({path}, filesOfSession(session.state, {})); !fine)
        return fine.error();
    ProjectExtras extras;
    extras.sessionPath = session.sessionPath;
    if (session.journal)
        extras.journal = session.journal->finished();
    if (!session.thumbnail.isNull()) {
        QBuffer buffer(&extras.thumbnail);
        buffer.open(QIODevice::WriteOnly);
        session.thumbnail.save(&buffer, "PNG");
    }
    return saveProjectBytes(writer.bytes(session.state, extras), path);
}

Result<SavedProject> writeOrTell(ProjectWriter &writer, const SessionToSave &session, const QString &path)
{
    try {
        return write(writer, session, path);
    } catch (const std::bad_alloc &) {
        return Error{SessionSaver::tr("there is not enough memory to save the session"), path, 0,
                     SessionSaver::tr("Close other programs")};
    } catch (const std::exception &e) {
        return Error{QString::fromUtf8(e.what()), path, 0, {}};
    }
}

} // namespace

SessionSaver::SessionSaver(QObject *parent) : QObject(parent)
{
    // A pool with one thread runs its tasks in order.
    mThread.setMaxThreadCount(1);
}

SessionSaver::~SessionSaver()
{
    mThread.waitForDone();
}

void SessionSaver::save(SessionToSave session, const QString &path, const std::optional<FileStamp> &expected,
                        Saved saved)
{
    ++mSaving;
    mThread.start([this, session = std::move(session), path, expected, saved = std::move(saved)] {
        SessionSaved result;
        const FileStamp there = FileStamp::of(path);
        result.wasGone = expected && expected->exists() && !there.exists();
        result.isForeign = expected && there.exists() && there != *expected;
        if (!result.isForeign)
            result.result = writeOrTell(mWriter, session, path);
        result.stamp = FileStamp::of(path);
        if (session.locks && !result.isForeign && result.result)
            result.lock = std::make_shared<SessionLock>(path);
        QMetaObject::invokeMethod(
            this,
            [this, saved, result = std::move(result)] {
                --mSaving;
                saved(result);
            },
            Qt::QueuedConnection);
    });
}

void SessionSaver::waitForDone()
{
    while (isBusy()) {
        mThread.waitForDone();
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    }
}

} // namespace autocuts
