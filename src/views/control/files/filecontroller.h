// Opens, saves and exports files; long operations run off the GUI thread. Asks the user nothing: that is done
// in actions/fileactions.
#pragma once

#include "commands/replay.h"
#include "model/editing/relink.h"
#include "model/io/projects/autosave.h"
#include "model/io/projects/projectfile.h"
#include "model/layouts/layoutfiles.h"
#include "model/layouts/uvexport.h"
#include "views/control/files/sessionsaver.h"
#include "views/control/session/jobrunner.h"

#include <QImage>
#include <QObject>

#include <functional>

namespace autocuts {

class Document;
class Preferences;
class SolverController;
class Workspace;
struct LoadedSession;
struct NewDocument;

//! A copy of the model for writing: its active UV set comes first.
Scene sceneForWriting(const Document &document);

//! Reads and writes the files of the session. Signals report success and failure.
class FileController final : public QObject
{
    Q_OBJECT

public:
    //! \param recoveryFolder folder of the autosaves
    FileController(Workspace &workspace, SolverController &solver, Preferences &preferences,
                   const QString &recoveryFolder, QObject *parent = nullptr);
    ~FileController() override;

    //! How a re-link ends.
    enum class RelinkEnd {
        Done,
        Failed,
        Edited //!< refused: the session was edited meanwhile
    };

    //! The job that reads a file, for progress and cancelling.
    JobRunner &jobs() { return mJobs; }
    //! The sessions that a crash left behind.
    std::vector<RecoverableSession> recoverable() const;

    //! Sets the source of the thumbnail in saved sessions; without it they have none.
    void setThumbnailSource(std::function<QImage()> source) { mThumbnail = std::move(source); }

    //! Sets the source of the views' state in saved sessions (Document::setViewState).
    void setViewStateSource(std::function<QByteArray()> source) { mViewState = std::move(source); }

    //! Reads a mesh or a session and replaces the open document.
    void open(const QString &path);
    //! Opens a sample model.
    void openSample(const QString &name);
    void recover(const RecoverableSession &session);
    //! Replaces the session's model by a version changed in another program, as one undo entry. The steering
    //! is transferred. Refused when the session is edited while the model is read. Emits relinkEnded(),
    //! unless it is cancelled. \param tellEdited emit failed(), too, when it is refused
    void relink(const QString &meshPath, bool tellEdited = true);
    //! What became of a model: what is lost, one line each, or why it was not taken.
    using Taken = std::function<void(const Result<QStringList> &lost)>;
    //! The same for a model that another program hands over. \param gesture those of one gesture are one
    //! entry of the history \param taken is not called when the job is cancelled or fails \returns false when
    //! another file is being read or written
    bool relinkHanded(const Scene &scene, quint64 gesture, const Taken &taken);
    //! Opens a model that was made or read. \param prepare changes the state that it begins with
    //! \returns why it cannot be opened
    Result<Done> adopt(Scene scene, const std::function<void(DocumentState &)> &prepare = {});
    //! Saves the current state of the session off the GUI thread. Emits done() or failed() afterwards.
    //! When another program has changed the session's file since it was opened or saved, nothing is written,
    //! and changedOnDisk() is emitted. \param overwrite replace it all the same
    void save(const QString &path, bool overwrite = false);
    //! True when another program has removed the session's file.
    bool isGone() const;
    bool isSaving() const { return mSaver.isBusy(); }
    //! Waits for all saves and autosaves under way.
    void waitForSaves() { mSaver.waitForDone(); }
    //! Writes the model with its UV map off the GUI thread.
    void exportMesh(const QString &path);
    //! Writes pictures of the UV map off the GUI thread. \param pictures one per tile
    //! \param faces per face: it is drawn; empty: all are
    void exportLayout(const std::vector<LayoutPicture> &pictures, const LayoutOptions &options,
                      const std::vector<bool> &faces = {});
    //! Measures the map and writes its figures as JSON, off the GUI thread: the report of the command line.
    void exportReport(const QString &path);
    //! Writes a picture or a table that a panel has made, off the GUI thread.
    void exportBytes(const QString &path, const QByteArray &bytes);
    //! Autosaves at once instead of at the end of the interval.
    void saveForRecoveryNow();
    //! Autosaves at the next turn of the event loop when there is something that is not saved.
    void saveChangesForRecovery();
    //! Ends the session normally.
    void close();

Q_SIGNALS:
    //! \param message translated, one line, for the status bar
    void done(const QString &message);
    void failed(const autocuts::Error &error);
    //! A model, or another single file, was written.
    void wrote(const QString &path);
    void relinkEnded(autocuts::FileController::RelinkEnd end);
    //! The session's file was not replaced, see save().
    void changedOnDisk(const QString &path);
    //! What the user has to know of a result. \param items what it is about
    void noticed(const QString &message, const autocuts::Selection &items);
    //! A file was opened. Workspace::notes() has the notes for the user.
    void opened();

private:
    //! Reads the model to re-link to, on the thread of a job.
    using ReadModel = std::function<Result<Scene>(const std::atomic<bool> &stop)>;
    //! Receives what is lost, or why the model was not taken.
    using Relinking = std::function<void(RelinkEnd end, const Result<QStringList> &lost)>;
    bool relinkTo(const QString &path, quint64 gesture, const ReadModel &read, const Relinking &ended);
    void adoptNew(NewDocument made);
    void takeFile(const QString &path, const FileStamp &stamp, std::shared_ptr<SessionLock> lock);
    std::function<QStringList(bool ownModel)> filesToKeep() const;
    void adoptProject(LoadedSession project, const QString &sessionPath, const RecoverableSession *recovered);
    void beginAutosave(const RecoverableSession *continued);
    void applyPreferences();
    void tellBusy(const QString &path);
    void tellNotes(const QStringList &notes);
    void tellWritten(const Result<Done> &written, const QString &path);
    QStringList adoptRelinked(const Relinked &linked, quint64 gesture);
    void saveForRecovery(const QString &path, const Autosave::Saved &saved);
    SessionToSave sessionNow(const QString &sessionPath);
    void endAutosave();

    Workspace &mWorkspace;
    SolverController &mSolver;
    Preferences &mPreferences;
    QString mRecoveryFolder;
    JobRunner mJobs{JobRunner::OnCancel::LetGo};
    FileStamp mStamp;                   //!< of the session's file, when it was opened or saved
    std::shared_ptr<SessionLock> mLock; //!< of the session's file; null: there is none
    QString mLockedPath;
    std::unique_ptr<Autosave> mAutosave;
    SessionSaver mSaver; //!< declared after mAutosave: it finishes autosaves before mAutosave is destroyed
    std::function<QImage()> mThumbnail;
    std::function<QByteArray()> mViewState;
};

} // namespace autocuts
