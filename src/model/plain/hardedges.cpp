#include "model/plain/hardedges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts {

namespace {

//! Normals closer than this are equal: files round them. Chosen by hand.
const double equalCosine = std::cos(std::numbers::pi / 180);

bool differ(const Vec3 &a, const Vec3 &b)
{
    if (!a.allFinite() || !b.allFinite() || a.isZero(0) || b.isZero(0))
        return false;
    return a.stableNormalized().dot(b.stableNormalized()) < equalCosine;
}

} // namespace

bool saysAnything(const FileShading &shading)
{
    return std::ranges::any_of(shading.smoothing,
                               [](std::int64_t group) { return group != FileShading::unsaid; }) ||
           std::any_of(shading.normals.rowwise().begin(), shading.normals.rowwise().end(),
                       [](const auto &normal) { return normal.allFinite() && !normal.isZero(0); });
}

std::vector<bool> hardEdges(const MeshData &mesh, const FileShading &shading)
{
    if (!saysAnything(shading))
        return {};
    const auto groupsDiffer = [&](const EdgePair &pair) {
        const auto group = [&](int side) {
            return shading.smoothing[mesh.triangleFace[pair.triangle[side]]];
        };
        return !shading.smoothing.empty() && (group(0) != group(1) || group(0) == 0);
    };
    const auto normalsDiffer = [&](const std::array<int, 2> &end) {
        return shading.normals.rows() > 0 && differ(shading.normals.row(mesh.cornerOfSoup(end[0])),
                                                    shading.normals.row(mesh.cornerOfSoup(end[1])));
    };
    std::vector<bool> hard(mesh.edgePairs.size(), false);
    for (std::size_t e = 0; e < hard.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        hard[e] = !pair.diagonal &&
                  (groupsDiffer(pair) || normalsDiffer(pair.corner[0]) || normalsDiffer(pair.corner[1]));
    }
    return hard;
}

} // namespace autocuts
