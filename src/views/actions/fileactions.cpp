#include "views/actions/fileactions.h"

#include "model/io/meshes/meshfile.h"
#include "views/actions/actionregistry.h"
#include "views/actions/menubuilder.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/proposedfolder.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/exportlayoutdialog.h"
#include "views/dialogs/exportmeshdialog.h"
#include "views/dialogs/recoverydialog.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>

namespace autocuts {

namespace {

constexpr const char *samplePrefix = "file.sample.";

QString globs(const QStringList &suffixes)
{
    return QStringLiteral("*.") + suffixes.join(QStringLiteral(" *."));
}

QStringList saveFilters()
{
    return {FileActions::tr("Autocuts sessions (%1)").arg(globs({QLatin1String(projectSuffix)}))};
}

} // namespace

QStringList openFilters()
{
    const QString session = QLatin1String(projectSuffix);
    return {FileActions::tr("Meshes and sessions (%1)").arg(globs(QStringList(session) + readableFormats())),
            FileActions::tr("Autocuts sessions (%1)").arg(globs({session})),
            FileActions::tr("All files (*)")};
}

std::vector<LayoutPicture> layoutPictures(const Document &document, const QString &path,
                                          const std::vector<bool> &faces)
{
    const PackingSettings packing = document.packingSettings();
    return layoutPictures(path, document.mesh(), withoutOtherFaces(document.mesh(), document.uv(), faces),
                          packing.tileHeight(), packing.udimTile);
}

FileActions::FileActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions),
      mWatch(context.workspace, context.solver, context.files, context.map.jobs())
{
    connectActions();
    connect(&mWatch, &FileWatch::choiceChanged, this, &FileActions::showWatch);
    // After the save has ended: what is chosen may save again.
    connect(&context.files, &FileController::changedOnDisk, this, &FileActions::askChanged,
            Qt::QueuedConnection);
}

void FileActions::connectActions()
{
    const auto onTriggered = [this](const char *id, auto function) {
        connect(mContext.actions.action(id), &QAction::triggered, this, function);
    };
    onTriggered("file.open", [this] { askOpen(); });
    for (const ActionInfo &info : actionTable()) {
        const QString id = QLatin1String(info.id);
        if (!id.startsWith(QLatin1String(samplePrefix)))
            continue;
        const QString name = id.mid(qsizetype(qstrlen(samplePrefix)));
        onTriggered(info.id,
                    [this, name] { leaveSession([this, name] { mContext.files.openSample(name); }); });
    }
    onTriggered("file.clearRecent", [this] { mContext.preferences.clearRecentFiles(); });
    onTriggered("file.close", [this] { leaveSession([this] { mContext.files.close(); }); });
    onTriggered("file.save", [this] { save(); });
    onTriggered("file.saveAs", [this] { saveAs(); });
    onTriggered("file.relink", [this] { askRelink(); });
    onTriggered("file.watch", [this] {
        mWatch.setChoice({!mWatch.choice().watches, mWatch.choice().exports});
        showWatch();
    });
    onTriggered("file.exportAgain", [this] { askExportAgain(); });
    onTriggered("file.exportMesh", [this] { mContext.solver.whenPaused([this] { askExportMesh(); }); });
    onTriggered("file.exportReport", [this] { mContext.solver.whenPaused([this] { askExportReport(); }); });
    onTriggered("file.exportLayout", [this] { mContext.solver.whenPaused([this] { askExportLayout(); }); });
    onTriggered("file.quit", [this] {
        if (QWidget *window = mQuestions.window())
            window->close();
    });
}

void FileActions::fillRecentMenu(MenuBuilder &menus)
{
    mRecentMenu = menus.menu(QStringLiteral("File/Open recent"));
    connect(&mContext.preferences, &Preferences::recentFilesChanged, this, &FileActions::showRecent);
    showRecent();
}

void FileActions::showRecent()
{
    QAction *const clear = mContext.actions.action("file.clearRecent");
    mRecentMenu->removeAction(clear);
    mRecentMenu->clear();
    const QStringList files = mContext.preferences.recentFiles();
    int number = 1;
    for (const QString &path : files) {
        QString name = QFileInfo(path).fileName();
        name.replace(QLatin1Char('&'), QStringLiteral("&&"));
        // The first nine have their number as mnemonic.
        const QString text = number < 10 ? QStringLiteral("&%1  %2").arg(number).arg(name)
                                         : QStringLiteral("%1  %2").arg(number).arg(name);
        QAction *const action = mRecentMenu->addAction(text, this, [this, path] { openFile(path); });
        action->setToolTip(QDir::toNativeSeparators(path));
        ++number;
    }
    mRecentMenu->addSeparator();
    mRecentMenu->addAction(clear);
    mRecentMenu->menuAction()->setEnabled(!files.isEmpty());
}

void FileActions::leaveSession(const std::function<void()> &then)
{
    mContext.solver.whenPaused([this, then] {
        if (!mayLeave())
            return;
        // Results of jobs on the old session are no longer needed.
        mContext.map.jobs().abandon();
        then();
    });
}

bool FileActions::mayLeave()
{
    return mayEndJob() && mayLeaveChanges();
}

bool FileActions::mayEndJob()
{
    const JobRunner &jobs = mContext.map.jobs();
    return !jobs.isBusy() || mQuestions.confirm(tr("%1 is still going on. Stop it?").arg(jobs.title()),
                                                tr("What it has found so far will be lost."), tr("Stop it"));
}

bool FileActions::mayLeaveChanges()
{
    FileController &files = mContext.files;
    files.waitForSaves();
    if (!mContext.workspace.isModified() && !files.isGone())
        return true;
    switch (mQuestions.askUnsaved(mContext.workspace.name(), files.isGone())) {
    case Questions::Unsaved::Save:
        save();
        files.waitForSaves();
        return !mContext.workspace.isModified() && !files.isGone();
    case Questions::Unsaved::Discard:
        return true;
    case Questions::Unsaved::Cancel:
        break;
    }
    return false;
}

bool FileActions::mayClose()
{
    if (!mayEndJob())
        return false;
    SolverController &solver = mContext.solver;
    const bool solves = solver.isRunning() || solver.isPausing();
    if (!solves || (!solver.map() && !mContext.workspace.isModified()))
        return mayLeaveChanges();
    // The question does not wait for the solver.
    switch (mQuestions.askUnsaved(mContext.workspace.name(), mContext.files.isGone())) {
    case Questions::Unsaved::Save:
        // A window that is being closed cannot be closed again: later, at its own turn of the event loop.
        solver.whenPaused([this] {
            save();
            mContext.files.waitForSaves();
            QWidget *const window = mQuestions.window();
            if (window && !mContext.workspace.isModified())
                QMetaObject::invokeMethod(window, &QWidget::close, Qt::QueuedConnection);
        });
        break;
    case Questions::Unsaved::Discard:
        return true;
    case Questions::Unsaved::Cancel:
        break;
    }
    return false;
}

void FileActions::askChanged(const QString &path)
{
    switch (mQuestions.askChanged(QFileInfo(path).fileName())) {
    case Questions::Changed::Overwrite:
        mContext.files.save(path, true);
        break;
    case Questions::Changed::SaveAs:
        saveAs();
        break;
    case Questions::Changed::Reload:
        mContext.solver.whenPaused([this, path] { mContext.files.open(path); });
        break;
    case Questions::Changed::Cancel:
        break;
    }
}

void FileActions::openFile(const QString &path)
{
    leaveSession([this, path] {
        rememberFolder(path);
        if (const std::optional<RecoverableSession> session = chosenForRecovery(path))
            mContext.files.recover(*session);
        else
            mContext.files.open(path);
    });
}

//! Asks whether work on a file that a crash has left is to go on. \param path of the file; empty: of any
std::optional<RecoverableSession> FileActions::chosenForRecovery(const QString &path)
{
    std::vector<RecoverableSession> sessions = mContext.files.recoverable();
    std::erase_if(sessions, [&](const RecoverableSession &session) {
        const QString &of = session.sessionPath.isEmpty() ? session.modelPath : session.sessionPath;
        return !path.isEmpty() && QFileInfo(of) != QFileInfo(path);
    });
    if (sessions.empty())
        return std::nullopt;
    RecoveryDialog dialog(sessions, mQuestions);
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return std::nullopt;
    return dialog.chosen();
}

void FileActions::askOpen()
{
    const QString path = mQuestions.fileToOpen(tr("Open"), mContext.preferences.lastFolder(), openFilters());
    if (!path.isEmpty())
        openFile(path);
}

void FileActions::save()
{
    const QString path = mContext.workspace.sessionPath();
    if (path.isEmpty())
        saveAs();
    else
        mContext.files.save(path);
}

void FileActions::saveAs()
{
    if (!mContext.workspace.document())
        return;
    const QString path =
        mQuestions.fileToSave(tr("Save session"), proposedPath(QLatin1String(projectSuffix)), saveFilters());
    if (path.isEmpty())
        return;
    rememberFolder(path);
    mContext.files.save(path);
}

void FileActions::askRelink()
{
    if (!mContext.workspace.document())
        return;
    const QString folder = modelFolder(mContext.workspace, mContext.preferences);
    const QStringList filters{tr("Meshes (%1)").arg(globs(readableFormats())), tr("All files (*)")};
    const QString path = mQuestions.fileToOpen(tr("Re-link model"), folder, filters);
    if (!path.isEmpty())
        mContext.solver.whenPaused([this, path] { mContext.files.relink(path); });
}

//! What the file beside the model holds is not replaced unasked.
void FileActions::askExportAgain()
{
    const bool exports = !mWatch.choice().exports;
    const QString path = mWatch.exportPath();
    const bool may = !exports || !QFileInfo::exists(path) ||
                     mQuestions.confirm(tr("Replace %1 after each re-link?").arg(QFileInfo(path).fileName()),
                                        tr("Its content is lost."), tr("&Replace"));
    if (may)
        mWatch.setChoice({mWatch.choice().watches, exports});
    showWatch();
}

void FileActions::showWatch()
{
    mContext.actions.action("file.watch")->setChecked(mWatch.choice().watches);
    mContext.actions.action("file.exportAgain")->setChecked(mWatch.choice().exports);
}

void FileActions::askExportMesh()
{
    const Document *document = mContext.workspace.document();
    if (!document)
        return;
    ExportMeshDialog dialog(sceneForWriting(*document), proposedPath({}), mQuestions);
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    rememberFolder(dialog.path());
    mContext.files.exportMesh(dialog.path());
}

void FileActions::askExportLayout()
{
    const Document *document = mContext.workspace.document();
    if (!document)
        return;
    const MapFigures *figures = mContext.map.figures();
    const bool known = figures && mContext.map.figuresAreFresh();
    const PackingSettings packing = document->packingSettings();
    ExportLayoutDialog dialog(std::max(packing.textureSize, packing.height()),
                              proposedPath(QStringLiteral("png")),
                              known ? figures->overlapping : std::vector<int>(), mQuestions);
    const QList<int> selected = document->selection().faces;
    const std::vector<bool> hidden = document->hidden();
    const auto faceCount = static_cast<std::size_t>(document->mesh().faceCount());
    dialog.offerParts(!hidden.empty(), !selected.isEmpty());
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    std::vector<bool> faces;
    if (dialog.part() == LayoutPart::Shown) {
        faces = hidden;
        faces.flip();
    } else if (dialog.part() == LayoutPart::Selected) {
        faces.assign(faceCount, false);
        for (int face : selected)
            faces[static_cast<std::size_t>(face)] = true;
    }
    rememberFolder(dialog.path());
    LayoutOptions options = dialog.options();
    options.tileHeight = packing.tileHeight();
    const std::vector<LayoutPicture> pictures = layoutPictures(*document, dialog.path(), faces);
    if (pictures.size() == 1 || confirmReplacing(pictures))
        mContext.files.exportLayout(pictures, options, faces);
}

void FileActions::askExportReport()
{
    if (!mContext.workspace.document())
        return;
    const QString path = mQuestions.fileToSave(tr("Export report"), proposedPath(QStringLiteral("json")),
                                               {tr("JSON report (*.json)")});
    if (path.isEmpty())
        return;
    rememberFolder(path);
    mContext.files.exportReport(path);
}

//! Asks when there are files already that the dialog does not know of: the pictures of several tiles.
bool FileActions::confirmReplacing(const std::vector<LayoutPicture> &pictures)
{
    const auto there = std::count_if(pictures.begin(), pictures.end(), [](const LayoutPicture &picture) {
        return QFileInfo::exists(picture.path);
    });
    return there == 0 ||
           mQuestions.confirm(tr("Replace the pictures of %n tiles?", nullptr, static_cast<int>(there)),
                              tr("Their content is lost."), tr("&Replace"));
}

void FileActions::offerRecovery()
{
    if (const std::optional<RecoverableSession> session = chosenForRecovery({}))
        leaveSession([this, session] { mContext.files.recover(*session); });
}

//! A path next to the session or the model with another suffix; without suffix when it is empty.
QString FileActions::proposedPath(const QString &suffix) const
{
    QString base = mContext.workspace.sessionPath();
    if (base.isEmpty())
        base = mContext.workspace.document()->state().scene.path;
    const QFileInfo info(base);
    const QString name = info.completeBaseName().isEmpty() ? tr("untitled") : info.completeBaseName();
    const QDir folder(proposedFolder(mContext.workspace, mContext.preferences));
    return folder.filePath(suffix.isEmpty() ? name : name + QLatin1Char('.') + suffix);
}

void FileActions::rememberFolder(const QString &path)
{
    mContext.preferences.setLastFolder(QFileInfo(path).absolutePath());
}

} // namespace autocuts
