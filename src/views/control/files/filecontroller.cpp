#include "views/control/files/filecontroller.h"

#include "commands/newmap.h"
#include "commands/replacemodel.h"
#include "model/document/makesnapshot.h"
#include "model/io/files/savefile.h"
#include "model/io/files/setjournal.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/outputs/fileclashes.h"
#include "model/layouts/mapreport.h"
#include "model/pictures/texturefiles.h"
#include "model/samples/samples.h"
#include "solver/metrics/uvmetrics.h"
#include "views/control/files/opening.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/ui/preferences.h"

#include <QFileInfo>

namespace autocuts {

namespace {

//! The file of a session, as it is opened.
struct SessionFile
{
    FileStamp stamp;
    std::shared_ptr<SessionLock> lock;

    //! \param path of the session; empty: it has no file
    static SessionFile at(const QString &path)
    {
        return path.isEmpty() ? SessionFile()
                              : SessionFile{FileStamp::of(path), std::make_shared<SessionLock>(path)};
    }
    //! Who else has the session open: at once for the user, and for later with the notes on the model.
    void tellHolder(const QString &path, QStringList &told, QStringList &kept) const
    {
        if (!lock || lock->holder().isEmpty())
            return;
        const QString text =
            FileController::tr("%1 is open in %2 as well. What is saved first stays; the other one is asked")
                .arg(QFileInfo(path).fileName(), lock->holder());
        told.prepend(text);
        kept.prepend(text);
    }
};

//! The result of reading a file.
struct Opened
{
    Result<LoadedSession> project = Error{};
    Result<NewDocument> model = Error{};
    bool isProject = false;
    SessionFile file;
    QStringList notes; //!< on the file and on those beside it
};

//! The result of writing files.
struct Written
{
    Result<Done> result;
    QStringList notes; //!< on files beside them
};

//! Writes files on the thread of a job, after what a program that was killed has left beside them is ended.
Written writeBeside(const QString &path, const std::function<Result<Done>()> &write)
{
    QStringList notes = endBrokenSets({path});
    return {write(), std::move(notes)};
}

bool isSameSuffix(const QString &a, const QString &b)
{
    return QFileInfo(a).suffix().compare(QFileInfo(b).suffix(), Qt::CaseInsensitive) == 0;
}

} // namespace

Scene sceneForWriting(const Document &document)
{
    Scene scene = document.state().scene;
    // In a scene without a document, the first UV set is the active one.
    std::rotate(scene.uvSets.begin(), scene.uvSets.begin() + document.activeUvSet(),
                scene.uvSets.begin() + document.activeUvSet() + 1);
    return scene;
}

FileController::FileController(Workspace &workspace, SolverController &solver, Preferences &preferences,
                               const QString &recoveryFolder, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mSolver(solver), mPreferences(preferences),
      mRecoveryFolder(recoveryFolder)
{
    connect(&mJobs, &JobRunner::failed, this, [this](const QString &message) {
        Q_EMIT failed(Error{message, {}, 0, {}});
    });
    connect(&workspace, &Workspace::historyChanged, this, [this] {
        if (!mAutosave)
            return;
        if (mWorkspace.isModified())
            mAutosave->sessionChanged();
        else
            mAutosave->sessionSaved();
    });
    // What a running solve has found is not in the document yet.
    connect(&solver, &SolverController::statusChanged, this, [this] {
        if (mAutosave && mSolver.isRunning() && mSolver.map())
            mAutosave->sessionChanged();
    });
    connect(&solver, &SolverController::stateChanged, this, [this] {
        if (!mSolver.isRunning() && !mSolver.isPausing() && mWorkspace.document())
            saveChangesForRecovery();
    });
    connect(&preferences, &Preferences::changed, this, &FileController::applyPreferences);
}

FileController::~FileController() = default;

void FileController::applyPreferences()
{
    const PreferenceValues &values = mPreferences.values();
    if (Document *document = mWorkspace.document())
        document->undoStack().setMemoryLimit(qint64(values.undoMemoryMb) * 1024 * 1024);
    if (!mAutosave && mWorkspace.document())
        beginAutosave(nullptr);
    if (mAutosave && values.autosaveSeconds > 0)
        mAutosave->setInterval(values.autosaveSeconds * 1000);
}

std::vector<RecoverableSession> FileController::recoverable() const
{
    return recoverableSessions(mRecoveryFolder);
}

void FileController::open(const QString &path)
{
    const QString full = QFileInfo(path).absoluteFilePath();
    const bool started = mJobs.start(
        tr("Opening %1").arg(QFileInfo(path).fileName()),
        [full, thread = thread(), preferences = mPreferences.values()](JobControl &job) {
            Opened opened;
            opened.notes = endBrokenSets({full});
            opened.isProject = isProjectPath(full);
            if (opened.isProject) {
                opened.file = SessionFile::at(full);
                opened.project = loadSession(full, thread, job.stop());
            } else
                opened.model = readModel(full, preferences, thread, job.stop());
            return opened;
        },
        [this, full](Opened opened) {
            const bool ok = opened.isProject ? opened.project.ok() : opened.model.ok();
            if (!ok) {
                tellNotes(opened.notes);
                Q_EMIT failed(opened.isProject ? opened.project.error() : opened.model.error());
                return;
            }
            mPreferences.addRecentFile(full);
            if (opened.isProject) {
                opened.file.tellHolder(full, opened.notes, opened.project->notes);
                takeFile(full, opened.file.stamp, std::move(opened.file.lock));
                adoptProject(std::move(opened.project).value(), full, nullptr);
            } else
                adoptNew(std::move(opened.model).value());
            tellNotes(opened.notes); // another model takes away what was told before
        });
    if (!started)
        tellBusy(full);
}

void FileController::openSample(const QString &name)
{
    Result<Scene> scene = makeSample(name);
    if (!scene)
        Q_EMIT failed(scene.error());
    else if (const Result<Done> adopted = adopt(std::move(scene).value()); !adopted)
        Q_EMIT failed(adopted.error());
}

void FileController::recover(const RecoverableSession &session)
{
    const bool started = mJobs.start(
        tr("Recovering"),
        [session, thread = thread()](JobControl &job) {
            Opened opened;
            opened.file = SessionFile::at(session.sessionPath);
            opened.project = loadSession(session.file, thread, job.stop());
            return opened;
        },
        [this, session](Opened opened) {
            if (!opened.project) {
                Q_EMIT failed(opened.project.error());
                return;
            }
            opened.file.tellHolder(session.sessionPath, opened.notes, opened.project->notes);
            takeFile(session.sessionPath, opened.file.stamp, std::move(opened.file.lock));
            adoptProject(std::move(opened.project).value(), session.sessionPath, &session);
            tellNotes(opened.notes); // another model takes away what was told before
        });
    if (!started)
        tellBusy(session.file);
}

Result<Done> FileController::adopt(Scene scene, const std::function<void(DocumentState &)> &prepare)
{
    Result<NewDocument> made = newDocument(std::move(scene), mPreferences.values(), prepare);
    if (!made)
        return made.error();
    adoptNew(std::move(made).value());
    return Done();
}

void FileController::adoptNew(NewDocument made)
{
    endAutosave();
    takeFile({}, {}, nullptr);
    mWorkspace.open(std::move(made.document), {}, std::nullopt, made.notes, std::move(made.drawing));
    beginAutosave(nullptr);
    applyPreferences();
    Q_EMIT opened();
}

//! The session has another file from now on. \param lock null: the lock that is there stays
void FileController::takeFile(const QString &path, const FileStamp &stamp, std::shared_ptr<SessionLock> lock)
{
    mStamp = stamp;
    // This program's own lock of the same file is no other's.
    if (path != mLockedPath || !mLock)
        mLock = std::move(lock);
    mLockedPath = path;
}

void FileController::adoptProject(LoadedSession project, const QString &sessionPath,
                                  const RecoverableSession *recovered)
{
    endAutosave();
    mWorkspace.open(std::move(project.session.document), sessionPath, std::move(project.session.past),
                    project.notes, std::move(project.drawing));
    if (recovered)
        mWorkspace.setRecovered(true);
    beginAutosave(recovered);
    applyPreferences();
    Q_EMIT opened();
}

void FileController::beginAutosave(const RecoverableSession *continued)
{
    if (mPreferences.values().autosaveSeconds <= 0)
        return;
    Result<std::unique_ptr<Autosave>> autosave = Autosave::start(
        mRecoveryFolder,
        [this](const QString &path, const Autosave::Saved &saved) { saveForRecovery(path, saved); },
        continued);
    if (!autosave) {
        Q_EMIT failed(autosave.error());
        return;
    }
    mAutosave = std::move(autosave).value();
    connect(mAutosave.get(), &Autosave::failed, this, &FileController::failed);
}

//! Autosaves under way must not write the recovery file again after it was removed.
void FileController::endAutosave()
{
    waitForSaves();
    mAutosave.reset();
}

void FileController::saveForRecovery(const QString &path, const Autosave::Saved &saved)
{
    mSaver.save(sessionNow(mWorkspace.sessionPath()), path, std::nullopt,
                [saved](const SessionSaved &written) {
                    saved(written.result ? Result<Done>(Done()) : Result<Done>(written.result.error()));
                });
}

//! The session as it is shown: with the newest map of a running solve, as a pause would leave it.
SessionToSave FileController::sessionNow(const QString &sessionPath)
{
    Document &document = *mWorkspace.document();
    SessionToSave session{document.state(), mWorkspace.recorder().pending(),
                          mThumbnail ? mThumbnail() : QImage(), sessionPath};
    if (mViewState)
        session.state.viewState = mViewState();
    const bool solves = mSolver.isRunning() || mSolver.isPausing();
    if (const std::shared_ptr<const unwrap::LiveMapResult> live = solves ? mSolver.map() : nullptr) {
        const std::unique_ptr<SetUvs> command = newMapCommand(document, UvEdit::Solve, live->uv);
        if (command->hasAnyChanges()) {
            session.state.scene.uvSets[session.state.activeUvSet].uv = live->uv;
            session.state.uvScales[session.state.activeUvSet] = command->scale();
            session.journal->add(command->toCbor());
        }
    }
    return session;
}

void FileController::save(const QString &path, bool overwrite)
{
    if (!mWorkspace.document())
        return;
    if (mViewState)
        mWorkspace.document()->setViewState(mViewState());
    SessionToSave session = sessionNow(path);
    session.locks = path != mLockedPath;
    std::optional<FileStamp> expected;
    if (!overwrite && path == mWorkspace.sessionPath() && mStamp.exists())
        expected = mStamp;
    mWorkspace.beginSave();
    mSaver.save(std::move(session), path, expected, [this, path](const SessionSaved &written) {
        const Result<SavedProject> &saved = written.result;
        mWorkspace.endSave(saved && !written.isForeign ? path : QString());
        if (written.isForeign) {
            Q_EMIT changedOnDisk(path);
            return;
        }
        if (!saved) {
            Q_EMIT failed(saved.error());
            return;
        }
        takeFile(path, written.stamp, written.lock);
        if (mAutosave) {
            // The last autosave is older than this save. Edits made during the save are autosaved again.
            mAutosave->sessionSaved();
            if (mWorkspace.isModified())
                mAutosave->sessionChanged();
        }
        mPreferences.addRecentFile(path);
        const QString name = QFileInfo(path).fileName();
        Q_EMIT done(written.wasGone ? tr("Saved %1 anew: the file was gone").arg(name)
                                    : tr("Saved %1").arg(name));
        if (!saved->warning.isEmpty())
            Q_EMIT failed(Error{saved->warning, path + QStringLiteral(".1"), 0,
                                tr("Check the permissions of the folder")});
    });
}

bool FileController::isGone() const
{
    return mStamp.exists() && !FileStamp::of(mWorkspace.sessionPath()).exists();
}

void FileController::relink(const QString &meshPath, bool tellEdited)
{
    if (!mWorkspace.document())
        return;
    const double tileHeight = mWorkspace.document()->packingSettings().tileHeight();
    const bool started = relinkTo(
        meshPath, 0, [=](const std::atomic<bool> &stop) { return readMesh(meshPath, &stop, tileHeight); },
        [this, tellEdited](RelinkEnd end, const Result<QStringList> &lost) {
            if (!lost && (tellEdited || end != RelinkEnd::Edited))
                Q_EMIT failed(lost.error());
            Q_EMIT relinkEnded(end);
        });
    if (!started)
        tellBusy(meshPath);
}

bool FileController::relinkHanded(const Scene &scene, quint64 gesture, const Taken &taken)
{
    return relinkTo(
        scene.path, gesture,
        [scene, own = mWorkspace.document()->state().scene](const std::atomic<bool> &) {
            return completedHanded(scene, own);
        },
        [taken](RelinkEnd, const Result<QStringList> &lost) { taken(lost); });
}

//! \pre a document is open
bool FileController::relinkTo(const QString &path, quint64 gesture, const ReadModel &read,
                              const Relinking &ended)
{
    const Document *document = mWorkspace.document();
    return mJobs.start(
        tr("Reading %1").arg(QFileInfo(path).fileName()),
        [state = document->state(), read](JobControl &job) -> Result<Relinked> {
            Result<Scene> scene = read(job.stop());
            if (!scene)
                return scene.error();
            return relinkDocument(state, std::move(scene).value(), [&job] { return job.stop().load(); });
        },
        [this, gesture, ended, token = document->token()](const Result<Relinked> &linked) {
            if (!linked)
                return ended(RelinkEnd::Failed, linked.error());
            const QString file = linked->state.scene.path;
            // A running solve counts as an edit that is not in the document yet.
            if (!mWorkspace.isInState(token) || mSolver.isRunning() || mSolver.isPausing())
                return ended(RelinkEnd::Edited,
                             Error{tr("The model was not re-linked, because the session was edited while the "
                                      "model was read"),
                                   file, 0, tr("Re-link it again and wait until it is read")});
            if (const QString problem = linked->state.validate(); !problem.isEmpty())
                return ended(RelinkEnd::Failed, Error{problem, file, 0, {}});
            ended(RelinkEnd::Done, adoptRelinked(linked.value(), gesture));
        });
}

//! \returns what is lost \pre the document is in the state that was re-linked
QStringList FileController::adoptRelinked(const Relinked &linked, quint64 gesture)
{
    const bool losesSource = mWorkspace.document()->state().scene.source && !linked.state.scene.source;
    auto command = std::make_unique<ReplaceModel>(*mWorkspace.document(), linked.state);
    command->setGesture(gesture);
    pushCommand(std::move(command));
    const QString name = QFileInfo(linked.state.scene.path).fileName();
    QStringList lines = linked.report.lines();
    if (losesSource)
        lines << tr("what only the file before had, such as bones and animation, is not written again");
    if (lines.isEmpty()) {
        Q_EMIT done(tr("Re-linked to %1: everything was kept").arg(name));
        return lines;
    }
    Selection items;
    items.mode = SelectionMode::Faces;
    items.faces = linked.report.newFaces;
    Q_EMIT noticed(tr("Re-linked to %1: %2").arg(name, lines.join(QStringLiteral("; "))), items);
    return lines;
}

//! The files that an export must not replace. Looks at the disk when it is called.
//! \returns a function of whether the model itself may be replaced
std::function<QStringList(bool ownModel)> FileController::filesToKeep() const
{
    return [model = mWorkspace.document()->state(), session = mWorkspace.sessionPath()](bool ownModel) {
        QStringList kept = filesOfSession(model, session);
        if (ownModel)
            kept.removeAll(model.scene.path);
        return kept;
    };
}

void FileController::exportMesh(const QString &path)
{
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    const bool started = mJobs.start(
        tr("Writing %1").arg(QFileInfo(path).fileName()),
        [scene = sceneForWriting(*document), sets = document->state().textureSets, path, kept = filesToKeep(),
         tileHeight = document->packingSettings().tileHeight()](JobControl &) {
            // The model itself may be written again, in its own format.
            const bool again = isSameSuffix(path, scene.path);
            return writeBeside(path, [&] {
                const Result<Done> fine = checkOutputs({path}, kept(again));
                return fine ? writeMesh(withChosenTextures(scene, sets), path, tileHeight) : fine;
            });
        },
        [this, path](const Written &written) {
            tellNotes(written.notes);
            tellWritten(written.result, path);
        });
    if (!started)
        tellBusy(path);
}

void FileController::exportLayout(const std::vector<LayoutPicture> &pictures, const LayoutOptions &options,
                                  const std::vector<bool> &faces)
{
    const Document *document = mWorkspace.document();
    const bool fits = faces.empty() || (document && std::ssize(faces) == document->mesh().faceCount());
    if (!document || !fits || pictures.empty()) // another model was opened meanwhile
        return;
    const QString &path = pictures.front().path;
    const bool started = mJobs.start(
        tr("Drawing %1").arg(QFileInfo(path).fileName()),
        [scene = sceneForWriting(*document), faces, pictures, options,
         kept = filesToKeep()](JobControl &job) {
            const Scene file = asWritten(scene, scene.format, options.tileHeight);
            const UvMatrix uv = withoutOtherFaces(*file.mesh, file.uvSets.front().uv, faces);
            QStringList paths;
            for (const LayoutPicture &picture : pictures)
                paths << picture.path;
            return writeBeside(paths.front(), [&] {
                const Result<Done> fine = checkOutputs(paths, kept(false));
                return fine ? writeLayoutPictures(pictures, *file.mesh, uv, options, &job.stop()) : fine;
            });
        },
        [this, path, count = int(pictures.size())](const Written &made) {
            tellNotes(made.notes);
            const Result<Done> &written = made.result;
            if (written && count > 1)
                Q_EMIT done(tr("Wrote %1 and %2 more").arg(QFileInfo(path).fileName()).arg(count - 1));
            else
                tellWritten(written, path);
        });
    if (!started)
        tellBusy(path);
}

void FileController::exportReport(const QString &path)
{
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    Scene scene = sceneForWriting(*document);
    scene.mesh = document->weightedMesh();
    const bool started = mJobs.start(
        tr("Measuring the map"),
        [scene = std::move(scene), path, flags = document->marks().faceFlags,
         packing = document->packingSettings(), kept = filesToKeep()](JobControl &job) -> Result<Done> {
            if (Result<Done> fine = checkOutputs({path}, kept(false)); !fine)
                return fine;
            const Scene file = asWritten(scene, scene.format, packing.tileHeight());
            metrics::UvMetricsOptions options;
            options.textureSize = packing.textureSize;
            options.tileHeight = packing.tileHeight();
            options.faceFlags = withInstanceStacks(file, flags);
            options.job = &job.stop();
            std::optional<metrics::UvMetrics> figures;
            if (file.hasUv())
                figures = metrics::measureUv(*file.mesh, file.uvSets.front().uv, options);
            MapReport report = mapReport(file, figures ? &*figures : nullptr, packing);
            report.input = scene.path;
            report.status = QStringLiteral("done");
            return saveAtomically(path, reportJson(report));
        },
        [this, path](const Result<Done> &written) { tellWritten(written, path); });
    if (!started)
        tellBusy(path);
}

void FileController::exportBytes(const QString &path, const QByteArray &bytes)
{
    if (!mWorkspace.document())
        return;
    const bool started = mJobs.start(
        tr("Writing %1").arg(QFileInfo(path).fileName()),
        [path, bytes, kept = filesToKeep()](JobControl &) {
            const Result<Done> fine = checkOutputs({path}, kept(false));
            return fine ? saveAtomically(path, bytes) : fine;
        },
        [this, path](const Result<Done> &written) { tellWritten(written, path); });
    if (!started)
        tellBusy(path);
}

void FileController::tellBusy(const QString &path)
{
    Q_EMIT failed(Error{tr("Another file is being read or written"), path, 0, tr("Wait or cancel it first")});
}

void FileController::tellNotes(const QStringList &notes)
{
    if (!notes.isEmpty())
        Q_EMIT noticed(notes.join(QStringLiteral(". ")), {});
}

void FileController::tellWritten(const Result<Done> &written, const QString &path)
{
    if (!written) {
        Q_EMIT failed(written.error());
        return;
    }
    Q_EMIT wrote(path);
    Q_EMIT done(tr("Wrote %1").arg(QFileInfo(path).fileName()));
}

void FileController::saveForRecoveryNow()
{
    if (mAutosave)
        mAutosave->saveNow();
}

void FileController::saveChangesForRecovery()
{
    // Not at once: this may be called while a command changes the document.
    if (mAutosave && mWorkspace.isModified())
        mAutosave->saveSoon();
}

void FileController::close()
{
    endAutosave();
    takeFile({}, {}, nullptr);
    mWorkspace.close();
}

} // namespace autocuts
