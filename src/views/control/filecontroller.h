// Opening, saving and exporting, off the GUI thread where it can take long. Asks nothing: see
// actions/fileactions.
#pragma once

#include "model/document/relink.h"
#include "model/io/autosave.h"
#include "model/io/projectfile.h"
#include "model/io/uvexport.h"
#include "views/control/jobrunner.h"
#include "views/control/sessionsaver.h"

#include <QImage>
#include <QObject>

#include <functional>

namespace autocuts {

class Document;
class Preferences;
class SolverController;
class Workspace;

//! The model as it is written: the active UV set is the first one.
Scene sceneForWriting(const Document &document);

//! Files of the session. Success and failure are told by signals.
class FileController final : public QObject
{
    Q_OBJECT

public:
    //! \param recoveryFolder where autosaves are kept
    FileController(Workspace &workspace, SolverController &solver, Preferences &preferences,
                   const QString &recoveryFolder, QObject *parent = nullptr);
    ~FileController() override;

    //! The file that is read, for progress and cancel.
    JobRunner &jobs() { return mJobs; }
    //! What a crash left behind.
    std::vector<RecoverableSession> recoverable() const;

    //! A picture for saved sessions; none when not set.
    void setThumbnailSource(std::function<QImage()> source) { mThumbnail = std::move(source); }

    //! The views' state, kept with saved sessions (Document::setViewState).
    void setViewStateSource(std::function<QByteArray()> source) { mViewState = std::move(source); }

    //! Reads a mesh or a session and replaces what is open.
    void open(const QString &path);
    //! A model that the program makes by itself.
    void openSample(const QString &name);
    void recover(const RecoverableSession &session);
    //! Puts the model, changed outside, in place of the one in the session; the steering is carried over, the
    //! history and the journal begin anew. Refused when the session is edited while the model is read.
    void relink(const QString &meshPath);
    //! Saves the session as it is now, off the GUI thread; done() or failed() follows.
    void save(const QString &path);
    bool isSaving() const { return mSaver.isBusy(); }
    //! Waits for all saves and autosaves that have begun.
    void waitForSaves() { mSaver.waitForDone(); }
    //! Writes the model with its map, off the GUI thread.
    void exportMesh(const QString &path);
    //! Writes a picture of the map, off the GUI thread. \param path .png or .svg
    void exportLayout(const QString &path, const LayoutOptions &options);
    //! Autosaves now instead of when it is due.
    void saveForRecoveryNow();
    //! Ends the session in order.
    void close();

Q_SIGNALS:
    //! \param message translated, one line, for the status bar
    void done(const QString &message);
    void failed(const autocuts::Error &error);
    //! A file was opened; what the user should know stands in Workspace::notes().
    void opened();

private:
    void adopt(Scene scene);
    void adoptProject(LoadedProject project, const QString &sessionPath, const RecoverableSession *recovered);
    void beginAutosave(const RecoverableSession *continued);
    void applyPreferences();
    void tellBusy(const QString &path);
    void tellWritten(const Result<Done> &written, const QString &path);
    void adoptRelinked(Result<Relinked> linked, const StateToken &token);
    void saveForRecovery(const QString &path, const Autosave::Saved &saved);
    SessionToSave sessionNow(const QString &sessionPath);
    void endAutosave();

    Workspace &mWorkspace;
    SolverController &mSolver;
    Preferences &mPreferences;
    QString mRecoveryFolder;
    JobRunner mJobs{JobRunner::OnCancel::LetGo};
    std::unique_ptr<Autosave> mAutosave;
    SessionSaver mSaver; //!< behind mAutosave: what that saves is written before its end
    std::function<QImage()> mThumbnail;
    std::function<QByteArray()> mViewState;
};

} // namespace autocuts
