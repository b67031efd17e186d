#include "commands/setseamstate.h"

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
    : ChangeElements(document), mEdit(edit)
{
    const IndexRanges pairs = withoutDiagonals(document.mesh(), cornerPairs);
    const std::vector<PairState> values(pairs.count(), stateOf(edit));
    mDelta = XorDelta::between<PairState>(document.seams().states.data(), pairs, values);
}

void SetSeamState::apply()
{
    editor().setSeamStates(mDelta.indices(), mDelta.applied(document().seams().states.data()));
}

bool SetSeamState::absorb(const DocumentCommand &newer)
{
    return static_cast<const SetSeamState &>(newer).mEdit == mEdit && ChangeElements::absorb(newer);
}

QString SetSeamState::label() const
{
    const int edges = edgeCountOf(mDelta.indices());
    switch (mEdit) {
    case Edit::Cut:
        return UndoText::tr("Cut %n edges", nullptr, edges);
    case Edit::Join:
        return UndoText::tr("Join %n edges", nullptr, edges);
    case Edit::Clear:
        break;
    }
    return UndoText::tr("Clear %n edges", nullptr, edges);
}

void SetSeamState::writePayload(QCborMap &map) const
{
    map["edit"_L1] = static_cast<int>(mEdit);
    writeSeamDelta(map, mDelta, document().mesh());
}

std::unique_ptr<SetSeamState> SetSeamState::fromCbor(Document &document, CborReader &reader)
{
    const Edit edit = reader.enumerator("edit"_L1, Edit::Join);
    XorDelta delta = readSeamDelta(reader, sizeof(PairState), document);
    const std::vector<PairState> states = delta.applied(document.seams().states.data());
    const bool valid =
        withoutDiagonals(document.mesh(), delta.indices()) == delta.indices() &&
        std::all_of(states.begin(), states.end(), [](PairState s) { return s <= PairState::Joined; });
    if (reader.failed() || !valid)
        return nullptr;
    auto command = std::make_unique<SetSeamState>(document, edit, IndexRanges());
    command->mDelta = std::move(delta);
    return command;
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
