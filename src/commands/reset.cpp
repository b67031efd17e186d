#include "commands/reset.h"

#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/keepstraight.h"
#include "commands/setislandflags.h"
#include "commands/setislandtag.h"
#include "commands/setseamstate.h"
#include "commands/setseamweights.h"
#include "commands/settexelweights.h"
#include "commands/setuvs.h"
#include "model/plain/uvlayout.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

std::unique_ptr<DocumentCommand> unpinAll(Document &document)
{
    std::vector<int> corners;
    for (const UvPin &pin : document.constraints().pins)
        corners.push_back(pin.corner);
    return EditPins::unpin(document, corners);
}

std::unique_ptr<DocumentCommand> removeRectangles(Document &document)
{
    std::vector<int> ids;
    for (const LayoutRectangle &rectangle : document.constraints().rectangles)
        ids.push_back(rectangle.id);
    return EditRectangles::remove(document, ids);
}

} // namespace

Reset::Reset(Document &document, int parts) : CommandGroup(document), mParts(parts & Everything)
{
    const IndexRanges pairs = IndexRanges::all(document.mesh().cornerPairCount());
    if ((parts & SeamStates) != 0)
        add(std::make_unique<SetSeamState>(document, SetSeamState::Edit::Clear, pairs));
    if ((parts & SeamWeights) != 0) {
        const std::vector<double> weights(pairs.count(), unpaintedWeight);
        add(std::make_unique<SetSeamWeights>(document, pairs, weights));
    }
    if ((parts & StraightEdges) != 0)
        add(std::make_unique<KeepStraight>(document, false, pairs));
    if ((parts & Pins) != 0)
        add(unpinAll(document));
    if ((parts & Rectangles) != 0)
        add(removeRectangles(document));
    if ((parts & TexelWeights) != 0)
        add(SetTexelWeights::uniform(document, IndexRanges::all(document.mesh().faceCount()), 1));
    if ((parts & Marks) != 0) {
        add(SetIslandFlags::clearAll(document));
        for (const IslandTag &tag : document.marks().tags)
            add(SetIslandTag::remove(document, tag.name));
    }
    if ((parts & Settings) != 0)
        add(std::make_unique<ChangeSettings>(document, SolveSettings(), PackingSettings()));
    if ((parts & Uvs) != 0)
        add(std::make_unique<SetUvs>(document, UvEdit::Clear, emptyLayout(document.mesh()),
                                     UvEditExtras{0, defaultUvScale, {}}));
}

QString Reset::label() const
{
    switch (mParts) {
    case SeamStates:
        return UndoText::tr("Reset seams");
    case SeamWeights:
        return UndoText::tr("Reset painted weights");
    case StraightEdges:
        return UndoText::tr("Release all straight edges");
    case Pins:
        return UndoText::tr("Remove all pins");
    case Rectangles:
        return UndoText::tr("Remove all rectangles");
    case TexelWeights:
        return UndoText::tr("Reset texel density weights");
    case Marks:
        return UndoText::tr("Reset island marks");
    case Settings:
        return UndoText::tr("Reset settings");
    case Uvs:
        return UndoText::tr("Clear UVs");
    case Steering:
        return UndoText::tr("Reset steering");
    case Everything:
        return UndoText::tr("Reset everything");
    default:
        return UndoText::tr("Reset");
    }
}

void Reset::writePayload(QCborMap &map) const
{
    map["parts"_L1] = mParts;
}

std::unique_ptr<Reset> Reset::fromCbor(Document &document, CborReader &reader)
{
    const int parts = static_cast<int>(reader.integer("parts"_L1, 0, Everything));
    if (reader.failed())
        return nullptr;
    return std::make_unique<Reset>(document, parts);
}

} // namespace autocuts
