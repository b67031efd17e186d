#include "model/transfer/surfacedistance.h"

#include "model/transfer/surfacetree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace autocuts::transfer {

namespace {

// Numbers in this file without another source were chosen by hand.

//! So many vertices are enough to tell whether the surfaces lie in one place.
constexpr int mostVertices = 20'000;
//! The others may be spikes or faults.
constexpr double nearlyAll = 0.999;

SurfaceTree treeOf(const MeshData &mesh)
{
    std::vector<Triangle3> triangles(static_cast<std::size_t>(mesh.triangleCount()));
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        for (std::size_t k = 0; k < 3; ++k)
            triangles[static_cast<std::size_t>(t)][k] = mesh.cornerPosition(mesh.triangles[t][k]);
    }
    return SurfaceTree(std::move(triangles));
}

//! The distances from vertices of a surface to the other one.
void addDistances(const MeshData &from, const SurfaceTree &to, double limit, const std::atomic<bool> &stop,
                  std::vector<double> &distances)
{
    const int step = from.cornerCount() / mostVertices + 1;
    for (int c = 0; c < from.cornerCount() && !stop; c += step) {
        const NearPoint near = to.nearest(from.cornerPosition(c), limit * limit);
        if (near.triangle >= 0)
            distances.push_back(std::sqrt(near.squared));
    }
    std::sort(distances.begin(), distances.end());
}

double mostOf(const std::vector<double> &sorted)
{
    const auto place = static_cast<std::size_t>(nearlyAll * static_cast<double>(sorted.size()));
    return sorted.empty() ? 0 : sorted[std::min(place, sorted.size() - 1)];
}

} // namespace

std::optional<double> surfaceDistance(const MeshData &a, const MeshData &b, double limit,
                                      const std::atomic<bool> &stop)
{
    std::vector<double> there, back;
    addDistances(a, treeOf(b), limit, stop, there);
    if (!stop)
        addDistances(b, treeOf(a), limit, stop, back);
    if (stop || (there.empty() && back.empty()))
        return {};
    return std::max(mostOf(there), mostOf(back));
}

std::optional<double> proposedCage(const MeshData &low, const MeshData &high, const std::atomic<bool> &stop)
{
    constexpr double farthest = 0.2, least = 0.001, room = 1.5;
    const double size = low.report.boxDiagonal;
    const std::optional<double> distance = surfaceDistance(low, high, farthest * size, stop);
    if (!distance || !(size > 0))
        return {};
    return std::round(1e4 * std::max(least, room * *distance / size)) / 1e4;
}

} // namespace autocuts::transfer
