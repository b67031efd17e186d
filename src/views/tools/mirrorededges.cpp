#include "views/tools/mirrorededges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autocuts {

namespace {

Vec3 middleOf(const MeshData &mesh, const EdgePair &edge)
{
    return 0.5 * (mesh.cornerPosition(mesh.cornerOfSoup(edge.corner[0][0])) +
                  mesh.cornerPosition(mesh.cornerOfSoup(edge.corner[1][0])));
}

//! A key with the same value for a point and its mirror image. The keys of two points differ by at most their
//! distance.
double sortingKey(const Vec3 &place)
{
    return 0.5 * std::abs(place.x()) + 0.7 * place.y() + 0.5 * place.z();
}

} // namespace

MirroredEdges::MirroredEdges(std::shared_ptr<const MeshData> mesh)
    : mMesh(std::move(mesh)), mMirrored(mMesh->edgePairs.size(), -1)
{
    // Only edges with similar keys are compared exactly.
    std::vector<Vec3> middles(mMirrored.size());
    std::vector<std::pair<double, int>> byKey;
    for (std::size_t e = 0; e < middles.size(); ++e) {
        const EdgePair &edge = mMesh->edgePairs[e];
        middles[e] = middleOf(*mMesh, edge);
        if (!edge.diagonal)
            byKey.emplace_back(sortingKey(middles[e]), static_cast<int>(e));
    }
    std::sort(byKey.begin(), byKey.end());
    for (const auto &[key, e] : byKey) {
        const Vec3 image(-middles[e].x(), middles[e].y(), middles[e].z());
        double nearest = 0.25 * mMesh->edgePairs[e].length;
        auto candidate = std::lower_bound(byKey.begin(), byKey.end(), std::pair(key - nearest, -1));
        for (const double last = key + nearest; candidate != byKey.end() && candidate->first <= last;
             ++candidate) {
            const double distance = (middles[candidate->second] - image).stableNorm();
            if (distance < nearest || (distance == nearest && mMirrored[e] < 0)) {
                nearest = distance;
                mMirrored[e] = candidate->second;
            }
        }
    }
}

} // namespace autocuts
