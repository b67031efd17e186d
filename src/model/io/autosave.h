// Saving now and then, so that a crash costs minutes at most, and finding what a crash left behind.
//
// Every running session has a file ID.lock in a folder for recovery, held for as long as the program runs,
// and after the first autosave a project file ID.acproj. Both vanish when the session ends in order. A
// project file without a lock that a living process holds is what a crash left behind.
#pragma once

#include "model/document/result.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <vector>

namespace autocuts {

//! A session that ended without order.
struct RecoverableSession
{
    QString file;        //!< to be opened with loadProject()
    QString sessionPath; //!< the file that the user knows the session by, empty when it was never saved
    QDateTime savedAt;   //!< of the last autosave
};

//! All sessions in the folder that can be recovered, the newest first. Removes what is left of sessions that
//! never came to an autosave, and of saves that were killed.
std::vector<RecoverableSession> recoverableSessions(const QString &folder);

//! Removes a session that nobody wants back; does nothing when it is in use.
void discardSession(const RecoverableSession &session);

//! The recovery file of one running session.
class Autosave final : public QObject
{
    Q_OBJECT

public:
    static constexpr int defaultInterval = 2 * 60 * 1000; //!< milliseconds

    using Saved = std::function<void(const Result<Done> &saved)>;
    //! Writes the session, as it is now, to the path; may do so on another thread, in the order of the calls.
    //! Calls `saved` on the thread of the Autosave when that has ended.
    using Save = std::function<void(const QString &path, Saved saved)>;

    //! Begins a session.
    //! \param folder made when it is not there
    //! \param continued a session to recover: its file is kept until the first autosave of this one replaces
    //! it; an Error when another program has taken it up
    static Result<std::unique_ptr<Autosave>> start(const QString &folder, Save save,
                                                   const RecoverableSession *continued = nullptr);
    //! Ends the session in order: nothing is left to recover. \pre no save is under way
    ~Autosave() override;

    //! \pre milliseconds > 0
    void setInterval(int milliseconds);
    int interval() const { return mTimer.interval(); }
    //! The project file that it saves to.
    const QString &file() const { return mFile; }

    //! There is something new to save: it will be, one interval after the first of these calls.
    void sessionChanged();
    //! The user saved the session or went back to what is saved: nothing is left to recover, of saves that
    //! are under way neither.
    void sessionSaved();

public Q_SLOTS:
    //! Saves now instead of when it is due.
    void saveNow();

Q_SIGNALS:
    //! An autosave failed. It is tried again after another interval.
    void failed(const autocuts::Error &error);

private:
    Autosave(QString file, std::unique_ptr<QLockFile> lock, Save save);

    void saveEnded(const Result<Done> &saved);

    QString mFile;
    std::unique_ptr<QLockFile> mLock;
    Save mSave;
    QTimer mTimer;
    int mSaving = 0;        //!< saves under way
    bool mUnwanted = false; //!< what they write is to be removed
};

} // namespace autocuts
