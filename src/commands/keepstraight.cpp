#include "commands/keepstraight.h"

#include "commands/seamdelta.h"
#include "commands/setseamstate.h"

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! True when every edge with one corner pair in the set has both there, and is no diagonal.
bool hasWholeEdges(const MeshData &mesh, const IndexRanges &cornerPairs)
{
    bool whole = cornerPairs.count() % 2 == 0;
    int next = 0, last = -1;
    cornerPairs.forEach([&](int pair) {
        whole = whole && !mesh.edgePairs[pair / 2].diagonal &&
                (next++ % 2 == 0 ? pair % 2 == 0 : pair == last + 1);
        last = pair;
    });
    return whole;
}

} // namespace

KeepStraight::KeepStraight(Document &document, bool on, const IndexRanges &cornerPairs)
    : ChangeElements(document), mOn(on)
{
    const IndexRanges pairs = withoutDiagonals(document.mesh(), cornerPairs);
    const std::vector<std::uint8_t> values(pairs.count(), on ? 1 : 0);
    mDelta = XorDelta::between<std::uint8_t>(document.seams().straight.data(), pairs, values);
}

void KeepStraight::apply()
{
    editor().setSeamStraight(mDelta.indices(), mDelta.applied(document().seams().straight.data()));
}

bool KeepStraight::absorb(const DocumentCommand &newer)
{
    return static_cast<const KeepStraight &>(newer).mOn == mOn && ChangeElements::absorb(newer);
}

QString KeepStraight::label() const
{
    const int edges = edgeCountOf(mDelta.indices());
    if (mOn)
        return UndoText::tr("Keep %n edges straight", nullptr, edges);
    return UndoText::tr("Release %n straight edges", nullptr, edges);
}

void KeepStraight::writePayload(QCborMap &map) const
{
    map["on"_L1] = mOn;
    writeSeamDelta(map, mDelta, document().mesh());
}

std::unique_ptr<KeepStraight> KeepStraight::fromCbor(Document &document, CborReader &reader)
{
    const bool on = reader.boolean("on"_L1);
    XorDelta delta = readSeamDelta(reader, sizeof(std::uint8_t), document);
    const std::vector<std::uint8_t> values = delta.applied(document.seams().straight.data());
    const bool valid =
        hasWholeEdges(document.mesh(), delta.indices()) &&
        std::all_of(values.begin(), values.end(), [&](std::uint8_t v) { return v == (on ? 1 : 0); });
    if (reader.failed() || !valid)
        return nullptr;
    auto command = std::make_unique<KeepStraight>(document, on, IndexRanges());
    command->mDelta = std::move(delta);
    return command;
}

} // namespace autocuts
