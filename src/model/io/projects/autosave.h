// Periodic saving and recovery of sessions after a crash.
//
// Each running session has a lock file ID.lock in the recovery folder, held while the program runs, and after
// the first autosave a project file ID.acproj. Both are removed when the session ends normally. A project
// file whose lock is not held by a running process was left by a crash.
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

//! A session that did not end normally.
struct RecoverableSession
{
    QString file;        //!< project file for loadProject()
    QString sessionPath; //!< the file that the user saved the session to; empty when it was never saved
    QString modelPath;   //!< the model's file; empty for a sample
    QDateTime savedAt;   //!< time of the last autosave
};

//! All recoverable sessions in the folder, the newest first. Removes the files of sessions that ended before
//! their first autosave, and of interrupted saves.
std::vector<RecoverableSession> recoverableSessions(const QString &folder);

//! Removes a session that is not to be recovered; does nothing when a running process uses it.
void discardSession(const RecoverableSession &session);

//! Autosaves one running session to a recovery file.
class Autosave final : public QObject
{
    Q_OBJECT

public:
    // Milliseconds; chosen by hand.
    static constexpr int defaultInterval = 20 * 1000;
    static constexpr int restInterval =
        3 * 1000; //!< without a change, after which a save does not wait longer

    using Saved = std::function<void(const Result<Done> &saved)>;
    //! Writes the current session to the path. May do so on another thread, but saves must end in the order
    //! of the calls. Calls `saved` on the thread of the Autosave afterwards.
    using Save = std::function<void(const QString &path, Saved saved)>;

    //! Begins to autosave a session.
    //! \param folder created when it does not exist
    //! \param continued a recovered session: its file is kept until the first autosave of this session
    //! replaces it. Error when another process has opened it
    static Result<std::unique_ptr<Autosave>> start(const QString &folder, Save save,
                                                   const RecoverableSession *continued = nullptr);
    //! Ends the session normally and removes its recovery files. \pre no save is under way
    ~Autosave() override;

    //! A save that is due at a time is not put off. \pre milliseconds > 0
    void setInterval(int milliseconds);
    int interval() const { return mInterval; }
    //! The project file of the autosaves.
    const QString &file() const { return mFile; }

    //! Says that the session has changed. It is saved one interval after the first of these calls, or as soon
    //! as it has rested for a moment.
    void sessionChanged();
    //! The session has changed, and is saved at the next turn of the event loop.
    void saveSoon();
    //! Says that the user saved the session or returned to the saved state. Removes the recovery file, also
    //! that of a save that is under way.
    void sessionSaved();

public Q_SLOTS:
    //! Saves at once instead of at the end of the interval.
    void saveNow();

Q_SIGNALS:
    //! An autosave failed. Another one follows after the interval.
    void failed(const autocuts::Error &error);

private:
    Autosave(QString file, std::unique_ptr<QLockFile> lock, Save save);

    void saveEnded(const Result<Done> &saved);

    QString mFile;
    std::unique_ptr<QLockFile> mLock;
    Save mSave;
    int mInterval = defaultInterval;
    QTimer mLatest;         //!< runs from the first change on
    QTimer mRest;           //!< runs from the newest change on
    int mSaving = 0;        //!< number of saves under way
    bool mUnwanted = false; //!< the files of these saves are to be removed
};

} // namespace autocuts
