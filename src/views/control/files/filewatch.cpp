#include "views/control/files/filewatch.h"

#include "model/io/formats/meshformats.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"

#include <QFileInfo>
#include <QGuiApplication>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Milliseconds for which a file rests before it is read. Chosen by hand: programs that write in pieces pause
//! less.
constexpr int restTime = 300;

//! The model's file; empty when it has none, as samples.
QString modelPath(const Document *document)
{
    const QString path = document ? document->state().scene.path : QString();
    return QFileInfo(path).isAbsolute() ? path : QString();
}

} // namespace

FileWatch::FileWatch(Workspace &workspace, SolverController &solver, FileController &files,
                     const JobRunner &jobs, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mSolver(solver), mFiles(files), mJobs(jobs)
{
    mRest.setSingleShot(true);
    mRest.setInterval(restTime);
    connect(&mRest, &QTimer::timeout, this, &FileWatch::look);
    connect(&mWatcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::lookSoon);
    connect(&mWatcher, &QFileSystemWatcher::directoryChanged, this, &FileWatch::lookSoon);
    connect(&workspace, &Workspace::documentReplaced, this, &FileWatch::follow);
    connect(&files, &FileController::opened, this, [this] { setChoice({}); });
    connect(&files, &FileController::wrote, this, [this](const QString &path) {
        if (path == mPath)
            mKnown = FileStamp::of(path);
    });
    connect(&files, &FileController::relinkEnded, this, [this](FileController::RelinkEnd end) {
        if (end == FileController::RelinkEnd::Edited)
            mKnown = {}; // read again
        mExportDue = mExportDue || (mChoice.exports && end == FileController::RelinkEnd::Done);
        mRest.start();
    });
}

void FileWatch::setChoice(const Choice &choice)
{
    if (choice == mChoice)
        return;
    mChoice = choice;
    mExportPath = choice.exports ? exportPath() : QString();
    mExportDue = false;
    follow();
    Q_EMIT choiceChanged();
}

QCborMap FileWatch::toCbor() const
{
    QCborMap map;
    map[u"watches"_s] = mChoice.watches;
    map[u"exports"_s] = mChoice.exports;
    if (mKnown.exists()) {
        map[u"size"_s] = mKnown.size;
        map[u"modified"_s] = mKnown.modified;
    }
    return map;
}

void FileWatch::restore(const QCborMap &saved)
{
    setChoice({saved[u"watches"_s].toBool(), saved[u"exports"_s].toBool()});
    const bool isOther =
        saved[u"size"_s].toInteger() != mKnown.size || saved[u"modified"_s].toInteger() != mKnown.modified;
    if (!mPath.isEmpty() && saved.contains(u"size"_s) && isOther) {
        mKnown = {};
        lookSoon();
    }
}

QString FileWatch::exportPath() const
{
    const QFileInfo model(modelPath(mWorkspace.document()));
    if (model.filePath().isEmpty())
        return {};
    return model.path() + u'/' + model.completeBaseName() + u"_uv."_s +
           formatToWrite(model.suffix().toLower());
}

//! The document has another model, or the choice is another one.
void FileWatch::follow()
{
    if (!mWorkspace.document() && mChoice != Choice()) {
        mChoice = {};
        Q_EMIT choiceChanged();
    }
    const QString path = mChoice.watches ? modelPath(mWorkspace.document()) : QString();
    if (path == mPath)
        return;
    if (const QStringList before = mWatcher.files() + mWatcher.directories(); !before.isEmpty())
        mWatcher.removePaths(before);
    mPath = path;
    mKnown = mSeen = path.isEmpty() ? FileStamp() : FileStamp::of(path);
    watchAgain();
}

//! A file that took the place of another is not watched yet.
void FileWatch::watchAgain()
{
    if (mPath.isEmpty())
        return;
    for (const QString &path : {mPath, QFileInfo(mPath).path()}) {
        if (!mWatcher.files().contains(path) && !mWatcher.directories().contains(path) &&
            QFileInfo::exists(path))
            mWatcher.addPath(path);
    }
}

void FileWatch::lookSoon()
{
    watchAgain();
    mRest.start();
}

bool FileWatch::isIdle() const
{
    return !mFiles.jobs().isBusy() && !mJobs.isBusy() && !QGuiApplication::modalWindow() &&
           QGuiApplication::mouseButtons() == Qt::NoButton;
}

//! Called when nothing has happened to the file for a while.
void FileWatch::look()
{
    const FileStamp now = mPath.isEmpty() ? FileStamp() : FileStamp::of(mPath);
    const bool rests = now == mSeen;
    mSeen = now;
    const bool isNew = now.exists() && now != mKnown;
    if (!isNew && !mExportDue)
        return;
    if (!rests || !isIdle())
        mRest.start();
    else if (isNew)
        mSolver.whenPaused([this] { relink(); });
    else if (std::exchange(mExportDue, false))
        exportAgain();
}

//! Writes the model again, unless that has another file by now, whose neighbour nobody was asked about.
void FileWatch::exportAgain()
{
    if (exportPath() != mExportPath)
        setChoice({mChoice.watches, false});
    else if (!mExportPath.isEmpty())
        mFiles.exportMesh(mExportPath);
}

void FileWatch::relink()
{
    if (mPath.isEmpty())
        return;
    if (!isIdle()) {
        mRest.start();
        return;
    }
    mKnown = mSeen;
    mFiles.relink(mPath, false);
}

} // namespace autocuts
