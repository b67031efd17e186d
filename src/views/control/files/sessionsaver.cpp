#include "views/control/files/sessionsaver.h"

#include "model/io/outputs/fileclashes.h"

#include <QBuffer>

namespace autocuts {

namespace {

Result<SavedProject> writeSession(ProjectWriter &writer, const SessionToSave &session, const QString &path)
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

} // namespace

SessionSaver::SessionSaver(QObject *parent) : QObject(parent) {}

SessionSaver::~SessionSaver()
{
    mTells = false;
    waitForDone();
}

void SessionSaver::save(SessionToSave session, const QString &path, const std::optional<FileStamp> &expected,
                        Saved saved)
{
    mOrders.push_back({std::move(session), path, expected, std::move(saved)});
    if (mOrders.size() == 1)
        writeNext();
}

void SessionSaver::writeNext()
{
    mWriting.start([this, &order = mOrders.front()](const std::atomic<bool> &) { return write(order); },
                   [this](const SessionSaved &result) { end(result); },
                   [this](const QString &message) {
                       SessionSaved failed;
                       failed.result = Error{message, mOrders.front().path, 0, {}};
                       failed.stamp = FileStamp::of(mOrders.front().path);
                       end(failed);
                   });
}

//! On the thread of mWriting.
SessionSaved SessionSaver::write(const Order &order)
{
    SessionSaved saved;
    const FileStamp there = FileStamp::of(order.path);
    saved.wasGone = order.expected && order.expected->exists() && !there.exists();
    saved.isForeign = order.expected && there.exists() && there != *order.expected;
    if (!saved.isForeign)
        saved.result = writeSession(mWriter, order.session, order.path);
    saved.stamp = FileStamp::of(order.path);
    if (order.session.locks && !saved.isForeign && saved.result)
        saved.lock = std::make_shared<SessionLock>(order.path);
    return saved;
}

void SessionSaver::end(const SessionSaved &result)
{
    const Saved saved = std::move(mOrders.front().saved);
    mOrders.pop_front();
    if (!mOrders.empty())
        writeNext();
    if (mTells)
        saved(result);
}

void SessionSaver::waitForDone()
{
    while (isBusy())
        mWriting.wait();
}

} // namespace autocuts
