// Writes sessions to disk in the background.
#pragma once

#include "commands/journalrecorder.h"
#include "model/io/projectfile.h"

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <functional>

namespace autocuts {

//! The state of a session at one moment, as copies and shared constant data.
struct SessionToSave
{
    DocumentState state;
    std::optional<PendingJournal> journal;
    QImage thumbnail;    //!< may be null
    QString sessionPath; //!< see ProjectExtras
};

//! Compresses and writes sessions on a separate thread, in the order in which they are given.
class SessionSaver final : public QObject
{
    Q_OBJECT

public:
    using Saved = std::function<void(const Result<SavedProject> &saved)>;

    explicit SessionSaver(QObject *parent = nullptr);
    //! Waits until everything is written; callbacks are no longer called.
    ~SessionSaver() override;

    //! \param saved called on the GUI thread when the file was written or writing failed
    void save(SessionToSave session, const QString &path, Saved saved);
    bool isBusy() const { return mSaving > 0; }
    //! Waits until everything is written and all callbacks have been called.
    void waitForDone();

private:
    QThreadPool mThread;
    ProjectWriter mWriter; //!< used on that thread only
    int mSaving = 0;
};

} // namespace autocuts
