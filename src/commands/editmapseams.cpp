#include "commands/editmapseams.h"

#include "model/plain/uvseams.h"

#include <algorithm>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The corner pairs of the edges that the user cut.
IndexRanges cutPairs(const Document &document, std::span<const int> edges)
{
    IndexRanges result;
    cornerPairsOfEdges(document.mesh(), edges).forEach([&](int pair) {
        if (document.seams().states[pair] == PairState::Cut)
            result.append(pair);
    });
    return result;
}

//! The number of edges in the text of the history. Edges that were open before are not counted, unless all
//! were: then the edit only forces these seams.
int editedCount(const Document &document, EditMapSeams::Edit edit, std::span<const int> edges)
{
    const auto count = static_cast<int>(edges.size());
    if (edit == EditMapSeams::Edit::Stitch)
        return count;
    const std::vector<bool> open = openCornerPairs(document.mesh(), document.uv());
    const auto wereOpen = static_cast<int>(std::count_if(
        edges.begin(), edges.end(), [&](int edge) { return open[2 * edge] || open[2 * edge + 1]; }));
    return wereOpen < count ? count - wereOpen : count;
}

//! The pins of the corners whose UVs change, at their new places.
std::vector<UvPin> movedPins(const Document &document, const UvMatrix &uv)
{
    std::vector<UvPin> pins;
    for (UvPin pin : document.constraints().pins) {
        if (uv.row(pin.corner) == document.uv().row(pin.corner) || !uv.row(pin.corner).allFinite())
            continue;
        pin.position = uv.row(pin.corner).transpose();
        pins.push_back(pin);
    }
    return pins;
}

} // namespace

std::unique_ptr<EditMapSeams> EditMapSeams::make(Document &document, Edit edit, const UvMatrix &uv,
                                                 std::span<const int> edges)
{
    UvEditExtras extras;
    extras.pins = movedPins(document, uv);
    auto states =
        edit != Edit::Stitch
            ? std::make_unique<SetSeamState>(document, SetSeamState::Edit::Cut,
                                             cornerPairsOfEdges(document.mesh(), edges))
            : std::make_unique<SetSeamState>(document, SetSeamState::Edit::Clear, cutPairs(document, edges));
    return std::make_unique<EditMapSeams>(document, edit, editedCount(document, edit, edges),
                                          std::make_unique<SetUvs>(document, UvEdit::Move, uv, extras),
                                          std::move(states));
}

EditMapSeams::EditMapSeams(Document &document, Edit edit, int count, std::unique_ptr<SetUvs> uvs,
                           std::unique_ptr<SetSeamState> states)
    : CommandGroup(document), mEdit(edit), mCount(count)
{
    add(std::move(uvs));
    add(std::move(states));
}

bool EditMapSeams::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const EditMapSeams &>(newer);
    return other.mEdit == mEdit && absorbParts(other);
}

QString EditMapSeams::label() const
{
    if (mEdit == Edit::Tear)
        return UndoText::tr("Tear %n edges", nullptr, mCount);
    if (mEdit == Edit::Rip)
        return UndoText::tr("Rip %n edges", nullptr, mCount);
    return UndoText::tr("Stitch %n edges", nullptr, mCount);
}

void EditMapSeams::writePayload(QCborMap &map) const
{
    map["edit"_L1] = static_cast<int>(mEdit);
    map["count"_L1] = mCount;
    map["uvs"_L1] = payloadOf(0);
    map["states"_L1] = payloadOf(1);
}

std::unique_ptr<EditMapSeams> EditMapSeams::fromCbor(Document &document, CborReader &reader)
{
    const Edit edit = reader.enumerator("edit"_L1, Edit::Tear);
    const int count = static_cast<int>(reader.integer("count"_L1, 0, std::numeric_limits<int>::max()));
    CborReader uvReader(reader.map("uvs"_L1)), stateReader(reader.map("states"_L1));
    auto uvs = SetUvs::fromCbor(document, uvReader);
    auto states = SetSeamState::fromCbor(document, stateReader);
    if (reader.failed() || !uvs || !states)
        return nullptr;
    return std::make_unique<EditMapSeams>(document, edit, count, std::move(uvs), std::move(states));
}

} // namespace autocuts
