#include "commands/setuvs.h"

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
    editor().setUvs(mUvSet, mDelta.indices(), toggledRows(mDelta, document().uvSets()[mUvSet].uv));
}

void SetUvs::toggleFlags()
{
    if (!mFlags.isEmpty())
        editor().setFaceFlags(mFlags.indices(), mFlags.applied(document().marks().faceFlags.data()));
}

void SetUvs::apply()
{
    toggleUvs();
    toggleFlags();
    editor().setUvScale(mUvSet, mScaleAfter);
    for (const auto &change : mPins.changes())
        editor().setPin(change.key, change.after);
}

void SetUvs::revert()
{
    toggleUvs();
    toggleFlags();
    editor().setUvScale(mUvSet, mScaleBefore);
    for (const auto &change : mPins.changes())
        editor().setPin(change.key, change.before);
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
        return UndoText::tr("Move %n islands", nullptr, mCount);
    case UvEdit::Rotate:
        return UndoText::tr("Rotate %n islands", nullptr, mCount);
    case UvEdit::Scale:
        return UndoText::tr("Scale %n islands", nullptr, mCount);
    case UvEdit::Drag:
        return UndoText::tr("Drag %n vertices", nullptr, mCount);
    case UvEdit::Pack:
        return UndoText::tr("Pack %n islands", nullptr, mCount);
    case UvEdit::Align:
        return UndoText::tr("Align %n islands", nullptr, mCount);
    case UvEdit::Distribute:
        return UndoText::tr("Distribute %n islands", nullptr, mCount);
    case UvEdit::Mirror:
        return UndoText::tr("Mirror %n islands", nullptr, mCount);
    case UvEdit::Orient:
        return UndoText::tr("Orient %n islands", nullptr, mCount);
    case UvEdit::Scatter:
        return UndoText::tr("Randomise %n islands", nullptr, mCount);
    case UvEdit::Straighten:
        return UndoText::tr("Straighten %n chains of edges", nullptr, mCount);
    case UvEdit::Relax:
        return UndoText::tr("Relax %n faces", nullptr, mCount);
    case UvEdit::AlignToAxes:
        return UndoText::tr("Align %n islands to the axes", nullptr, mCount);
    case UvEdit::Grid:
        return UndoText::tr("Straighten %n faces to a grid", nullptr, mCount);
    case UvEdit::Solve:
        return UndoText::tr("Solve");
    case UvEdit::Unwrap:
        return UndoText::tr("Unwrap");
    case UvEdit::UnwrapSelection:
        return UndoText::tr("Unwrap selection");
    case UvEdit::FinishSelection:
        return UndoText::tr("Finish selection");
    case UvEdit::Finish:
        return UndoText::tr("Finish map");
    case UvEdit::Separate:
        return UndoText::tr("Separate overlaps");
    case UvEdit::Transfer:
        return UndoText::tr("Transfer UVs");
    case UvEdit::BrushRelax:
        return UndoText::tr("Relax with a brush");
    case UvEdit::BrushPinch:
        return UndoText::tr("Pinch");
    case UvEdit::BrushGrab:
        return UndoText::tr("Grab");
    case UvEdit::Clear:
        break;
    }
    return UndoText::tr("Clear UVs");
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

std::unique_ptr<SetUvs> SetUvs::fromCbor(Document &document, CborReader &reader)
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
            return nullptr;
    }
    if (reader.failed() || uvSet != document.activeUvSet() ||
        !std::all_of(extras.pins.begin(), extras.pins.end(), pinned))
        return nullptr;
    auto command = std::make_unique<SetUvs>(document, edit, document.uv(), extras);
    command->mDelta = std::move(delta);
    command->mFlags = std::move(flags);
    return command;
}

} // namespace autocuts
