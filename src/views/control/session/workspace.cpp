#include "views/control/session/workspace.h"

#include "views/gl/meshdrawing.h"

#include <QFileInfo>

namespace autocuts {

Workspace::Workspace(QObject *parent) : QObject(parent) {}

Workspace::~Workspace()
{
    // Receivers of the signals must not find a document that is being destroyed.
    if (mDocument) {
        mDocument->disconnect(this);
        mDocument->undoStack().disconnect(this);
    }
}

void Workspace::open(std::unique_ptr<Document> document, const QString &sessionPath,
                     std::optional<Journal> journal, const QStringList &notes,
                     std::shared_ptr<const MeshDrawing> drawing)
{
    if (mDocument) {
        mDocument->disconnect(this);
        mDocument->undoStack().disconnect(this);
    }
    mRecorder.reset();
    // The previous document is destroyed after all receivers have changed to the new one.
    const std::unique_ptr<Document> previous = std::exchange(mDocument, std::move(document));
    mSessionPath = sessionPath;
    mNotes = notes;
    mDrawing = std::move(drawing);
    mRecovered = false;
    mSaving = 0;
    if (mDocument) {
        mRecorder = std::make_unique<JournalRecorder>(*mDocument, std::move(journal));
        attach();
    }
    Q_EMIT documentReplaced();
    Q_EMIT selectionChanged();
    Q_EMIT historyChanged();
}

const std::shared_ptr<const MeshDrawing> &Workspace::drawing() const
{
    const Scene &scene = mDocument->state().scene;
    if (!mDrawing || mDrawing->mesh != scene.mesh)
        mDrawing = std::make_shared<const MeshDrawing>(scene.mesh, scene.hardEdges);
    return mDrawing;
}

void Workspace::close()
{
    open(nullptr, {});
}

void Workspace::attach()
{
    connect(mDocument.get(), &Document::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::Model) {
            Q_EMIT documentReplaced();
            Q_EMIT selectionChanged();
        }
        Q_EMIT changed(event);
    });
    connect(mDocument.get(), &Document::selectionChanged, this, &Workspace::selectionChanged);
    const UndoStack &stack = mDocument->undoStack();
    connect(&stack, &QUndoStack::indexChanged, this, &Workspace::historyChanged);
    connect(&stack, &QUndoStack::cleanChanged, this, &Workspace::historyChanged);
}

void Workspace::beginSave()
{
    UndoStack &stack = mDocument->undoStack();
    mWasSaved = mSaving == 0 && stack.isClean();
    ++mSaving;
    stack.setClean();
    Q_EMIT historyChanged();
}

void Workspace::endSave(const QString &path)
{
    --mSaving;
    if (!path.isEmpty()) {
        mSessionPath = path;
        mRecovered = false;
    } else if (mSaving == 0 && !mWasSaved) {
        mDocument->undoStack().resetClean();
    }
    Q_EMIT historyChanged();
}

QString Workspace::name() const
{
    if (!mDocument)
        return {};
    const QString path = mSessionPath.isEmpty() ? mDocument->state().scene.path : mSessionPath;
    return path.isEmpty() ? tr("Untitled") : QFileInfo(path).fileName();
}

bool Workspace::isModified() const
{
    return mDocument && (mRecovered || mSaving > 0 || !mDocument->undoStack().isClean());
}

bool Workspace::hasMapOf(const StateToken &token) const
{
    return mDocument && mDocument->token().sameMap(token);
}

bool Workspace::isInState(const StateToken &token) const
{
    return mDocument && mDocument->token() == token;
}

void Workspace::setRecovered(bool recovered)
{
    mRecovered = recovered;
    if (recovered && mDocument)
        mDocument->undoStack().resetClean(); // no entry is the one that the file has
    Q_EMIT historyChanged();
}

} // namespace autocuts
