#include "commands/setseamstate.h"

#include "commands/commandreading.h"
#include "commands/seamdelta.h"

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

PairState stateOf(SetSeamState::Edit edit)
{
    switch (edit) {
    case SetSeamState::Edit::Cut:
        return PairState::Cut;
    case SetSeamState::Edit::Join:
        return PairState::Joined;
    case SetSeamState::Edit::Clear:
        break;
    }
    return PairState::Free;
}

} // namespace

SetSeamState::SetSeamState(Document &document, Edit edit, const IndexRanges &cornerPairs)
    : DocumentCommand(document), mEdit(edit)
{
    const IndexRanges pairs = withoutDiagonals(document.mesh(), cornerPairs);
    const std::vector<PairState> values(pairs.count(), stateOf(edit));
    mDelta = XorDelta::between<PairState>(document.seams().states.data(), pairs, values);
}

void SetSeamState::apply()
{
    setSeamStates(mDelta.indices(), mDelta.applied(document().seams().states.data()));
}

bool SetSeamState::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const SetSeamState &>(newer);
    if (other.mEdit != mEdit)
        return false;
    mDelta.combine(other.mDelta);
    return true;
}

QString SetSeamState::label() const
{
    const int edges = edgeCountOf(mDelta.indices());
    switch (mEdit) {
    case Edit::Cut:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Cut %n edge"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Cut %n edges"), edges);
    case Edit::Join:
        return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Join %n edge"),
                           QT_TRANSLATE_NOOP("Undo Commands", "Join %n edges"), edges);
    case Edit::Clear:
        break;
    }
    return countedText(QT_TRANSLATE_NOOP("Undo Commands", "Clear %n edge"),
                       QT_TRANSLATE_NOOP("Undo Commands", "Clear %n edges"), edges);
}

void SetSeamState::writePayload(QCborMap &map) const
{
    map["edit"_L1] = static_cast<int>(mEdit);
    writeSeamDelta(map, mDelta, document().mesh());
}

Result<std::unique_ptr<DocumentCommand>> SetSeamState::fromCbor(Document &document, CborReader &reader)
{
    const Edit edit = reader.enumerator("edit"_L1, Edit::Join);
    XorDelta delta = readSeamDelta(reader, sizeof(PairState), document);
    const std::vector<PairState> states = delta.applied(document.seams().states.data());
    const bool valid =
        withoutDiagonals(document.mesh(), delta.indices()) == delta.indices() &&
        std::all_of(states.begin(), states.end(), [](PairState s) { return s <= PairState::Joined; });
    if (reader.failed() || !valid)
        return damagedCommand();
    auto command = std::make_unique<SetSeamState>(document, edit, IndexRanges());
    command->mDelta = std::move(delta);
    return std::unique_ptr<DocumentCommand>(std::move(command));
}

IndexRanges cornerPairsOfEdges(const MeshData &mesh, std::span<const int> edges)
{
    std::vector<int> sorted(edges.begin(), edges.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    IndexRanges result;
    for (int edge : sorted) {
        if (edge < 0 || edge >= static_cast<int>(mesh.edgePairs.size()) || mesh.edgePairs[edge].diagonal)
            continue;
        result.append(IndexRange{2 * edge, 2 * edge + 2});
    }
    return result;
}

IndexRanges withoutDiagonals(const MeshData &mesh, const IndexRanges &cornerPairs)
{
    IndexRanges result;
    cornerPairs.forEach([&](int pair) {
        if (!mesh.edgePairs[pair / 2].diagonal)
            result.append(pair);
    });
    return result;
}

int edgeCountOf(const IndexRanges &cornerPairs)
{
    int count = 0;
    int last = -1;
    cornerPairs.forEach([&](int pair) {
        count += pair / 2 != last;
        last = pair / 2;
    });
    return count;
}

} // namespace autocuts
