// Watches the file that the model came from.
#pragma once

#include "model/io/files/sessionlock.h"
#include "views/control/files/filecontroller.h"

#include <QCborMap>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace autocuts {

//! Re-links the model when another program has saved its file, as one undo entry. Waits until size and time
//! of the file rest, until no job runs and the user holds no mouse button and no dialog; a solve is paused.
//! What this program writes itself counts for nothing, and so does a file that cannot be read until it is
//! saved again.
class FileWatch final : public QObject
{
    Q_OBJECT

public:
    //! What the user wants of a session.
    struct Choice
    {
        bool watches = false;
        bool exports = false; //!< writes exportPath() after each re-link

        bool operator==(const Choice &) const = default;
    };

    //! \param jobs those that work on the map
    FileWatch(Workspace &workspace, SolverController &solver, FileController &files, const JobRunner &jobs,
              QObject *parent = nullptr);

    const Choice &choice() const { return mChoice; }
    void setChoice(const Choice &choice);
    //! The choice, and which version of the file the model is.
    QCborMap toCbor() const;
    //! Takes the choice of a session that was opened. Re-links when the file has changed since it was saved.
    void restore(const QCborMap &saved);
    //! Beside the model: NAME_uv in its own format, or in one that holds the most. Empty when the model has
    //! no file.
    QString exportPath() const;

Q_SIGNALS:
    void choiceChanged();

private:
    void follow();
    void watchAgain();
    void lookSoon();
    void look();
    void relink();
    void exportAgain();
    bool isIdle() const;

    Workspace &mWorkspace;
    SolverController &mSolver;
    FileController &mFiles;
    const JobRunner &mJobs;
    Choice mChoice;
    QString mExportPath; //!< the exportPath() that the choice was made for
    QString mPath;       //!< that is watched; empty: none
    FileStamp mKnown, mSeen;
    bool mExportDue = false;
    QFileSystemWatcher mWatcher;
    QTimer mRest;
};

} // namespace autocuts
