#include "views/link/linkmerging.h"

#include "commands/editpins.h"
#include "commands/edittextures.h"
#include "commands/newmap.h"
#include "commands/setseamstate.h"

#include <algorithm>

namespace autocuts {

using Edit = SetSeamState::Edit;

namespace {

//! Both corner pairs of the edges whose state is to change.
IndexRanges changingPairs(const Document &document, const std::vector<int> &edgePairs, bool cut)
{
    IndexRanges result;
    for (const int pair : edgePairs) {
        if (document.seams().edgeIs(pair, PairState::Cut) != cut)
            result.append({2 * pair, 2 * pair + 2});
    }
    return result;
}

UvPin pinOf(const link::LinkPin &pin, double tileHeight)
{
    return {pin.corner, Vec2(pin.u, double(pin.v) * tileHeight)};
}

} // namespace

void applyMarks(Document &document, const link::VertexPairs &edges, const link::MarkChanges &changes)
{
    const auto cut = [&](Edit edit, const std::vector<link::VertexPair> &names) {
        const IndexRanges pairs = changingPairs(document, edges.edgePairs(names), edit == Edit::Cut);
        if (!pairs.isEmpty())
            pushCommand(std::make_unique<SetSeamState>(document, edit, pairs));
    };
    cut(Edit::Cut, changes.cuts);
    cut(Edit::Clear, changes.uncuts);
    std::vector<UvPin> pins;
    for (const link::LinkPin &pin : changes.pins)
        pins.push_back(pinOf(pin, document.packingSettings().tileHeight()));
    if (!pins.empty())
        pushCommand(std::make_unique<EditPins>(document, EditPins::Edit::Pin, pins));
    if (!changes.unpins.empty())
        pushCommand(EditPins::unpin(document, changes.unpins));
    if (changes.faces) {
        Selection selection = document.selection();
        selection.faces = *changes.faces;
        document.setSelection(selection);
    }
}

void applyTextures(Document &document, const link::NamedTextures &materials)
{
    const std::vector<QString> &own = document.state().scene.materialNames;
    std::vector<TextureSet> sets = document.state().textureSets;
    sets.resize(own.size() + 1); // the first set is that of faces without a material
    for (std::size_t i = 0; i < materials.names.size(); ++i) {
        const auto material = std::ranges::find(own, materials.names[i]) - own.begin();
        if (material == std::ssize(own))
            continue;
        TextureSet present = document.state().textureSet(int(material));
        for (const auto &[channel, picture] : materials.sets[i]) {
            if (present[channel].picture.file != picture.picture.file)
                sets[std::size_t(material) + 1][channel] = picture;
        }
    }
    pushCommand(std::make_unique<EditTextures>(document, withoutEmptyEnd(std::move(sets))));
}

void applyUvs(Document &document, const UvMatrix &uv)
{
    const double tileHeight = document.packingSettings().tileHeight();
    const link::LinkUvs rounded = link::toLinkUvs(uv, 1), own = link::toLinkUvs(document.uv(), tileHeight);
    UvMatrix changed = document.uv();
    for (Eigen::Index c = 0; c < uv.rows(); ++c) {
        if (uv.row(c).allFinite() && rounded.row(c) != own.row(c))
            changed.row(c) << uv(c, 0), uv(c, 1) * tileHeight;
    }
    pushCommand(newMapCommand(document, UvEdit::Transfer, changed));
}

void prepareMarks(DocumentState &state, const link::VertexPairs &edges, const link::MarkChanges &changes)
{
    for (const int pair : edges.edgePairs(changes.cuts))
        state.seams.states[2 * pair] = state.seams.states[2 * pair + 1] = PairState::Cut;
    for (const link::LinkPin &pin : changes.pins)
        state.constraints.pins.push_back(pinOf(pin, state.packingSettings.tileHeight()));
    state.selection.faces = changes.faces.value_or(QList<int>());
}

link::MapToSend toSend(const Document &document)
{
    link::MapToSend send;
    send.tileHeight = document.packingSettings().tileHeight();
    send.uvSet = document.uvSets()[document.activeUvSet()].name;
    send.states = document.seams().states;
    send.pins = document.constraints().pins;
    send.faces = document.selection().faces;
    link::NamedTextures textures{document.state().scene.materialNames, {}};
    for (int material = 0; material < int(textures.names.size()); ++material)
        textures.sets.push_back(document.state().textureSet(material));
    send.textures = textures.written();
    return send;
}

} // namespace autocuts
