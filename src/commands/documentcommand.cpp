#include "commands/documentcommand.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

qint64 unsharedBytes(const QList<int> &list, const QList<int> &below)
{
    return list.constData() == below.constData() ? 0 : list.size() * qint64(sizeof(int));
}

} // namespace

DocumentCommand::DocumentCommand(Document &document) : mDocument(document), mSelection(document.selection())
{
    const UndoStack &stack = document.undoStack();
    const QUndoCommand *below = stack.index() > 0 ? stack.command(stack.index() - 1) : nullptr;
    const Selection before = below ? static_cast<const DocumentCommand *>(below)->mSelection : Selection();
    mSelectionBytes = unsharedBytes(mSelection.faces, before.faces) +
                      unsharedBytes(mSelection.edges, before.edges) +
                      unsharedBytes(mSelection.corners, before.corners);
}

void DocumentCommand::undo()
{
    if (isReleased())
        return;
    revert();
    mDocument.setSelection(mSelection);
    setObsolete(mVanishes);
}

void DocumentCommand::redo()
{
    if (mWasApplied)
        mDocument.setSelection(mSelection);
    mWasApplied = true;
    apply();
}

bool DocumentCommand::mergeWith(const QUndoCommand *newer)
{
    const auto &other = static_cast<const DocumentCommand &>(*newer);
    if (isReleased() || mGesture == 0 || mGesture != other.mGesture || !absorb(other))
        return false;
    setText(label());
    setObsolete(!hasAnyChanges());
    return true;
}

bool DocumentCommand::absorb(const DocumentCommand &)
{
    return false;
}

QCborMap DocumentCommand::toCbor() const
{
    QCborMap map{{"id"_L1, id()}};
    writePayload(map);
    return map;
}

qint64 DocumentCommand::contentBytes() const
{
    return payloadBytes() + mSelectionBytes;
}

void DocumentCommand::clearContent()
{
    clearPayload();
    mSelection = {};
}

bool pushCommand(std::unique_ptr<DocumentCommand> command)
{
    if (!command->hasAnyChanges())
        return false;
    command->setText(command->label());
    UndoStack &stack = command->document().undoStack();
    stack.push(std::move(command));
    return true;
}

bool cancelGesture(Document &document, quint64 gesture)
{
    UndoStack &stack = document.undoStack();
    if (gesture == 0 || !stack.canUndoFurther())
        return false;
    // The stack returns its entries as const; only pushCommand() adds any.
    auto *newest =
        static_cast<DocumentCommand *>(const_cast<QUndoCommand *>(stack.command(stack.index() - 1)));
    if (newest->mGesture != gesture)
        return false;
    newest->mVanishes = true;
    stack.undo();
    return true;
}

} // namespace autocuts
