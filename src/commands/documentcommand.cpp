#include "commands/documentcommand.h"

#include <QCoreApplication>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

const char *const translationContext = "Undo Commands";

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

QString countedText(const char *one, const char *many, int count)
{
    return plainText(count == 1 ? one : many).replace("%n"_L1, QString::number(count));
}

QString plainText(const char *text)
{
    return QCoreApplication::translate(translationContext, text);
}

void DocumentCommand::setUvs(int uvSet, const IndexRanges &corners, const UvMatrix &values)
{
    mDocument.setUvs(uvSet, corners, values);
}

void DocumentCommand::setUvScale(int uvSet, double scale)
{
    mDocument.setUvScale(uvSet, scale);
}

void DocumentCommand::setSeamStates(const IndexRanges &cornerPairs, std::span<const PairState> values)
{
    mDocument.setSeamStates(cornerPairs, values);
}

void DocumentCommand::setSeamWeights(const IndexRanges &cornerPairs, std::span<const double> values)
{
    mDocument.setSeamWeights(cornerPairs, values);
}

void DocumentCommand::setSeamStraight(const IndexRanges &cornerPairs, std::span<const std::uint8_t> values)
{
    mDocument.setSeamStraight(cornerPairs, values);
}

void DocumentCommand::setPin(int corner, const std::optional<UvPin> &pin)
{
    mDocument.setPin(corner, pin);
}

void DocumentCommand::setRectangle(int id, const std::optional<LayoutRectangle> &rectangle)
{
    mDocument.setRectangle(id, rectangle);
}

void DocumentCommand::setFaceFlags(const IndexRanges &faces, std::span<const IslandFlags> values)
{
    mDocument.setFaceFlags(faces, values);
}

void DocumentCommand::setTexelWeights(const IndexRanges &faces, std::span<const double> values)
{
    mDocument.setTexelWeights(faces, values);
}

void DocumentCommand::setTag(const QString &name, const QList<int> &faces)
{
    mDocument.setTag(name, faces);
}

void DocumentCommand::setHiddenFaces(const QList<int> &faces)
{
    mDocument.setHiddenFaces(faces);
}

void DocumentCommand::setTextureSets(const std::vector<TextureSet> &sets)
{
    mDocument.setTextureSets(sets);
}

void DocumentCommand::setUniqueMeshes(bool unique)
{
    mDocument.setUniqueMeshes(unique);
}

void DocumentCommand::setSolveSettings(const SolveSettings &settings)
{
    mDocument.setSolveSettings(settings);
}

void DocumentCommand::setPackingSettings(const PackingSettings &settings)
{
    mDocument.setPackingSettings(settings);
}

void DocumentCommand::insertUvSet(int index, UvSet set, double scale)
{
    mDocument.insertUvSet(index, std::move(set), scale);
}

void DocumentCommand::removeUvSet(int index)
{
    mDocument.removeUvSet(index);
}

void DocumentCommand::renameUvSet(int index, const QString &name)
{
    mDocument.renameUvSet(index, name);
}

void DocumentCommand::exchangeModel(OtherModel &other)
{
    mDocument.exchangeModel(other);
}

void DocumentCommand::setActiveUvSet(int index)
{
    mDocument.setActiveUvSet(index);
}

} // namespace autocuts
