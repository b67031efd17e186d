// Writes sessions to disk in the background.
#pragma once

#include "commands/journalrecorder.h"
#include "model/io/files/sessionlock.h"
#include "model/io/projects/projectfile.h"
#include "views/ui/task.h"

#include <QImage>
#include <QObject>

#include <deque>
#include <functional>

namespace autocuts {

//! The state of a session at one moment, as copies and shared constant data.
struct SessionToSave
{
    DocumentState state;
    std::optional<PendingJournal> journal;
    QImage thumbnail;    //!< may be null
    QString sessionPath; //!< see ProjectExtras
    bool locks = false;  //!< the file is the session's from now on
};

//! What became of a save.
struct SessionSaved
{
    Result<SavedProject> result = SavedProject{};
    FileStamp stamp;                   //!< of the file that was written
    std::shared_ptr<SessionLock> lock; //!< of that file, where it was asked for
    bool isForeign = false; //!< nothing was written: the file there is not the one that was expected
    bool wasGone = false;   //!< the file that was expected was not there any more
};

//! Compresses and writes sessions on a separate thread, in the order in which they are given.
class SessionSaver final : public QObject
{
    Q_OBJECT

public:
    using Saved = std::function<void(const SessionSaved &saved)>;

    explicit SessionSaver(QObject *parent = nullptr);
    //! Waits until everything is written; callbacks are no longer called.
    ~SessionSaver() override;

    //! \param saved called on the GUI thread when the file was written or writing failed
    //! \param expected another file is not replaced; nothing: any file is
    void save(SessionToSave session, const QString &path, const std::optional<FileStamp> &expected,
              Saved saved);
    bool isBusy() const { return mWriting.isRunning(); }
    //! Waits until everything is written and all callbacks have been called.
    void waitForDone();

private:
    struct Order
    {
        SessionToSave session;
        QString path;
        std::optional<FileStamp> expected;
        Saved saved;
    };
    SessionSaved write(const Order &order);
    void writeNext();
    void end(const SessionSaved &result);

    std::deque<Order> mOrders; //!< the first one is being written
    ProjectWriter mWriter;     //!< used by mWriting only
    Task mWriting;
    bool mTells = true;
};

} // namespace autocuts
