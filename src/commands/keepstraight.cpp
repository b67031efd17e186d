#include "commands/keepstraight.h"

#include "commands/commandreading.h"
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
    : DocumentCommand(document), mOn(on)
{
    const IndexRanges pairs = withoutDiagonals(document.mesh(), cornerPairs);
    const std::vector<std::uint8_t> values(pairs.count(), on ? 1 : 0);
    mDelta = XorDelta::between<std::uint8_t>(document.seams().straight.data(), pairs, values);
}

void KeepStraight::apply()
{
    setSeamStraight(mDelta.indices(), mDelta.applied(document().seams().straight.data()));
}

bool KeepStraight::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const KeepStraight &>(newer);
    if (other.mOn != mOn)
        return false;
    mDelta.combine(other.mDelta);
    return true;
}

QString KeepStraight::label() const
{
    const int edges = edgeCountOf(mDelta.indices());
    if (mOn)
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Keep %n edge straight"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Keep %n edges straight"), edges);
    return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Release %n straight edge"),
                       QT_TRANSLATE_NOOP("Undo Commands", "Release %n straight edges"), edges);
}

void KeepStraight::writePayload(QCborMap &map) const
{
    map["on"_L1] = mOn;
    writeSeamDelta(map, mDelta, document().mesh());
}

Result<std::unique_ptr<DocumentCommand>> KeepStraight::fromCbor(Document &document, CborReader &reader)
{
    const bool on = reader.boolean("on"_L1);
    XorDelta delta = readSeamDelta(reader, sizeof(std::uint8_t), document);
    const std::vector<std::uint8_t> values = delta.applied(document.seams().straight.data());
    const bool valid =
        hasWholeEdges(document.mesh(), delta.indices()) &&
        std::all_of(values.begin(), values.end(), [&](std::uint8_t v) { return v == (on ? 1 : 0); });
    if (reader.failed() || !valid)
        return damagedCommand();
    auto command = std::make_unique<KeepStraight>(document, on, IndexRanges());
    command->mDelta = std::move(delta);
    return std::unique_ptr<DocumentCommand>(std::move(command));
}

} // namespace autocuts
