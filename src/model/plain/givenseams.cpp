#include "model/plain/givenseams.h"

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

std::vector<bool> givenSeams(const SeamSources &sources, const GivenSeamOptions &options)
{
    const MeshData &mesh = sources.mesh;
    const std::size_t count = mesh.edgePairs.size();
    const std::vector<bool> none(count, false);
    const std::vector<bool> inMap = options.map && sources.uv ? mapSeams(mesh, *sources.uv) : none;
    const std::vector<bool> &hard = options.hard && !sources.hardEdges.empty() ? sources.hardEdges : none;
    const std::vector<double> angles = options.sharp ? edgeAngles(mesh) : std::vector<double>(count, 0);
    const double sharpAngle = options.sharpAngle * std::numbers::pi / 180;
    const bool byMaterial = options.materials && !sources.faceMaterial.empty();
    std::vector<bool> given = none;
    for (std::size_t e = 0; e < count; ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const auto is = [&](PairState state) {
            return !sources.states.empty() &&
                   (sources.states[2 * e] == state || sources.states[2 * e + 1] == state);
        };
        const auto material = [&](int side) {
            return sources.faceMaterial[mesh.triangleFace[pair.triangle[side]]];
        };
        const bool cut = is(PairState::Cut);
        if (pair.diagonal || (is(PairState::Joined) && !cut))
            continue;
        given[e] = (options.cuts && cut) || inMap[e] || hard[e] || angles[e] > sharpAngle ||
                   (byMaterial && material(0) != material(1));
    }
    return given;
}

} // namespace autocuts
