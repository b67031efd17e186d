// Sessions on their way to the disk.
#pragma once

#include "commands/journalrecorder.h"
#include "model/io/projectfile.h"

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <functional>

namespace autocuts {

//! A session as it was at one moment: copies and shared data that nobody changes any more.
struct SessionToSave
{
    DocumentState state;
    std::optional<PendingJournal> journal;
    QImage thumbnail;    //!< may be null
    QString sessionPath; //!< see ProjectExtras
};

//! Packs and writes sessions on a thread of its own, one after the other in the order in which they come.
class SessionSaver final : public QObject
{
    Q_OBJECT

public:
    using Saved = std::function<void(const Result<Done> &saved)>;

    explicit SessionSaver(QObject *parent = nullptr);
    //! Waits until everything is written; nobody is called any more.
    ~SessionSaver() override;

    //! \param saved called on the GUI thread when the file is written, or when that failed
    void save(SessionToSave session, const QString &path, Saved saved);
    bool isBusy() const { return mSaving > 0; }
    //! Waits until everything is written and those who wanted to know have been called.
    void waitForDone();

private:
    QThreadPool mThread;
    ProjectWriter mWriter; //!< for that thread only
    int mSaving = 0;
};

} // namespace autocuts
