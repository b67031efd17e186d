#include "commands/setuvs.h"

#include "commands/commandreading.h"
#include "commands/uvrows.h"

#include <QCborArray>

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

SetUvs::SetUvs(Document &document, UvEdit edit, const UvMatrix &uv, const UvEditExtras &extras)
    : DocumentCommand(document), mEdit(edit), mUvSet(document.activeUvSet()), mCount(extras.count),
      mDelta(uvDelta(document.uv(), uv)), mScaleBefore(document.uvScale()),
      mScaleAfter(extras.scale.value_or(mScaleBefore)), mPins(changesToPins(document, extras.pins))
{
    if (!std::isfinite(mScaleAfter) || mScaleAfter <= 0)
        mScaleAfter = mScaleBefore;
    const std::vector<IslandFlags> &flags = document.marks().faceFlags;
    if (extras.flags.size() == flags.size())
        mFlags = XorDelta::between<IslandFlags>(
            flags.data(), IndexRanges::all(static_cast<int>(flags.size())), extras.flags);
}

bool SetUvs::hasAnyChanges() const
{
    return !mDelta.isEmpty() || mScaleBefore != mScaleAfter || !mPins.isEmpty() || !mFlags.isEmpty();
}

void SetUvs::toggleUvs()
{
    setUvs(mUvSet, mDelta.indices(), toggledRows(mDelta, document().uvSets()[mUvSet].uv));
}

void SetUvs::toggleFlags()
{
    if (!mFlags.isEmpty())
        setFaceFlags(mFlags.indices(), mFlags.applied(document().marks().faceFlags.data()));
}

void SetUvs::apply()
{
    toggleUvs();
    toggleFlags();
    setUvScale(mUvSet, mScaleAfter);
    for (const auto &change : mPins.changes())
        setPin(change.key, change.after);
}

void SetUvs::revert()
{
    toggleUvs();
    toggleFlags();
    setUvScale(mUvSet, mScaleBefore);
    for (const auto &change : mPins.changes())
        setPin(change.key, change.before);
}

bool SetUvs::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const SetUvs &>(newer);
    if (other.mEdit != mEdit || other.mUvSet != mUvSet)
        return false;
    mDelta.combine(other.mDelta);
    mScaleAfter = other.mScaleAfter;
    mPins.combine(other.mPins);
    mFlags.combine(other.mFlags);
    mCount = other.mCount;
    return true;
}

QString SetUvs::label() const
{
    switch (mEdit) {
    case UvEdit::Move:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Move %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Move %n islands"), mCount);
    case UvEdit::Rotate:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Rotate %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Rotate %n islands"), mCount);
    case UvEdit::Scale:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Scale %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Scale %n islands"), mCount);
    case UvEdit::Drag:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Drag %n vertex"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Drag %n vertices"), mCount);
    case UvEdit::Pack:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Pack %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Pack %n islands"), mCount);
    case UvEdit::Align:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Align %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Align %n islands"), mCount);
    case UvEdit::Distribute:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Distribute %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Distribute %n islands"), mCount);
    case UvEdit::Mirror:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Mirror %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Mirror %n islands"), mCount);
    case UvEdit::Orient:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Orient %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Orient %n islands"), mCount);
    case UvEdit::Scatter:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Randomise %n island"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Randomise %n islands"), mCount);
    case UvEdit::Straighten:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Straighten %n chain of edges"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Straighten %n chains of edges"), mCount);
    case UvEdit::Relax:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Relax %n face"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Relax %n faces"), mCount);
    case UvEdit::AlignToAxes:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Align %n island to the axes"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Align %n islands to the axes"), mCount);
    case UvEdit::Grid:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Straighten %n face to a grid"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Straighten %n faces to a grid"), mCount);
    case UvEdit::Solve:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Solve"));
    case UvEdit::Unwrap:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Unwrap"));
    case UvEdit::UnwrapSelection:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Unwrap selection"));
    case UvEdit::FinishSelection:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Finish selection"));
    case UvEdit::Finish:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Finish map"));
    case UvEdit::Separate:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Separate overlaps"));
    case UvEdit::Transfer:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Transfer UVs"));
    case UvEdit::BrushRelax:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Relax with a brush"));
    case UvEdit::BrushPinch:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Pinch"));
    case UvEdit::BrushGrab:
        return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Grab"));
    case UvEdit::Clear:
        break;
    }
    return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Clear UVs"));
}

qint64 SetUvs::payloadBytes() const
{
    return mDelta.byteCount() + mFlags.byteCount() + mPins.count() * qint64(sizeof(PinChanges::Change));
}

void SetUvs::clearPayload()
{
    mDelta = XorDelta(uvRowSize);
    mPins.clear();
    mFlags = XorDelta(sizeof(IslandFlags));
}

void SetUvs::compact()
{
    mDelta.pack(document().undoStack().pool(), document().adjacency().cornersByVertex());
    mFlags.pack(document().undoStack().pool());
}

void SetUvs::writePayload(QCborMap &map) const
{
    map["edit"_L1] = static_cast<int>(mEdit);
    map["uvSet"_L1] = mUvSet;
    map["count"_L1] = mCount;
    map["scale"_L1] = mScaleAfter;
    map["pins"_L1] = pinsToCbor(mPins);
    mDelta.write(map, document().adjacency().cornersByVertex());
    if (mFlags.isEmpty())
        return;
    QCborMap flags;
    mFlags.write(flags);
    map["flags"_L1] = flags;
}

Result<std::unique_ptr<DocumentCommand>> SetUvs::fromCbor(Document &document, CborReader &reader)
{
    const UvEdit edit = reader.enumerator("edit"_L1, UvEdit::FinishSelection);
    const int uvSet = static_cast<int>(reader.integer("uvSet"_L1, 0, std::numeric_limits<int>::max()));
    UvEditExtras extras;
    extras.count = static_cast<int>(reader.integer("count"_L1, 0, std::numeric_limits<int>::max()));
    extras.scale = reader.number("scale"_L1, std::numeric_limits<double>::min(), maxUvScale);
    extras.pins = readPins(reader, "pins"_L1, document.mesh());
    XorDelta delta = readUvDelta(reader, document, document.uv());
    const auto pinned = [&](const UvPin &pin) { return document.constraints().pin(pin.corner) != nullptr; };
    XorDelta flags(sizeof(IslandFlags));
    if (reader.contains("flags"_L1)) {
        CborReader own(reader.map("flags"_L1));
        flags = XorDelta::read(own, sizeof(IslandFlags), document.mesh().faceCount());
        if (own.failed() || !std::ranges::all_of(flags.applied(document.marks().faceFlags.data()),
                                                 [](const IslandFlags &f) { return isValid(f); }))
            return damagedCommand();
    }
    if (reader.failed() || uvSet != document.activeUvSet() ||
        !std::all_of(extras.pins.begin(), extras.pins.end(), pinned))
        return damagedCommand();
    auto command = std::make_unique<SetUvs>(document, edit, document.uv(), extras);
    command->mDelta = std::move(delta);
    command->mFlags = std::move(flags);
    return std::unique_ptr<DocumentCommand>(std::move(command));
}

} // namespace autocuts
