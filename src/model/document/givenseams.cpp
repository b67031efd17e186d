#include "model/document/givenseams.h"

#include "model/plain/edgeangles.h"
#include "model/plain/uvseams.h"

#include <numbers>

namespace autocuts {

namespace {

//! Per edge pair: both polygons have UVs, and their sides of the edge are apart.
std::vector<bool> mapSeams(const MeshData &mesh, const UvMatrix &uv)
{
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    std::vector<bool> seams(mesh.edgePairs.size(), false);
    for (std::size_t e = 0; e < seams.size(); ++e) {
        const auto &ends = mesh.edgePairs[e].corner;
        const auto hasUvs = [&](const std::array<int, 2> &end) {
            return uv.row(mesh.cornerOfSoup(end[0])).allFinite() &&
                   uv.row(mesh.cornerOfSoup(end[1])).allFinite();
        };
        seams[e] = (open[2 * e] || open[2 * e + 1]) && hasUvs(ends[0]) && hasUvs(ends[1]);
    }
    return seams;
}

} // namespace

std::vector<bool> givenSeams(const Scene &scene, const UvMatrix *uv, std::span<const PairState> states,
                             const GivenSeamOptions &options)
{
    const MeshData &mesh = *scene.mesh;
    const std::size_t count = mesh.edgePairs.size();
    const std::vector<bool> none(count, false);
    const std::vector<bool> inMap = options.map && uv ? mapSeams(mesh, *uv) : none;
    const std::vector<bool> &hard = options.hard && !scene.hardEdges.empty() ? scene.hardEdges : none;
    const std::vector<double> angles = options.sharp ? edgeAngles(mesh) : std::vector<double>(count, 0);
    const double sharpAngle = options.sharpAngle * std::numbers::pi / 180;
    const bool byMaterial = options.materials && !scene.faceMaterial.empty();
    std::vector<bool> given = none;
    for (std::size_t e = 0; e < count; ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const auto is = [&](PairState state) {
            return !states.empty() && (states[2 * e] == state || states[2 * e + 1] == state);
        };
        const auto material = [&](int side) {
            return scene.faceMaterial[mesh.triangleFace[pair.triangle[side]]];
        };
        const bool cut = is(PairState::Cut);
        if (pair.diagonal || (is(PairState::Joined) && !cut))
            continue;
        given[e] = (options.cuts && cut) || inMap[e] || hard[e] || angles[e] > sharpAngle ||
                   (byMaterial && material(0) != material(1));
    }
    return given;
}

bool changesGivenSeams(const ChangeEvent &event)
{
    switch (event.type) {
    case ChangeEvent::Type::Model:
    case ChangeEvent::Type::Uv:
    case ChangeEvent::Type::UvSet:
        return true;
    case ChangeEvent::Type::Seam:
        return (static_cast<const SeamEvent &>(event).properties & SeamEvent::State) != 0;
    case ChangeEvent::Type::SolveSettings:
        return (static_cast<const SolveSettingsEvent &>(event).properties &
                (SeamModeProperty | SeamSourcesProperty | SharpAngleProperty)) != 0;
    case ChangeEvent::Type::Pin:
    case ChangeEvent::Type::Rectangle:
    case ChangeEvent::Type::IslandFlag:
    case ChangeEvent::Type::Tag:
    case ChangeEvent::Type::Hidden:
    case ChangeEvent::Type::Textures:
    case ChangeEvent::Type::SharedMeshes:
    case ChangeEvent::Type::PackingSettings:
    case ChangeEvent::Type::TexelWeight:
        return false;
    }
    return false;
}

} // namespace autocuts
