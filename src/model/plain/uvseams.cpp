#include "model/plain/uvseams.h"

#include "model/plain/uvlayout.h"

namespace autocuts {

std::vector<bool> openCornerPairs(const MeshData &mesh, const UvMatrix &uv)
{
    const Eigen::AlignedBox2d box = layoutBox(uv);
    const double distance = box.isEmpty() ? 0 : uvTolerance * box.diagonal().stableNorm();
    std::vector<bool> open(mesh.cornerPairCount(), false);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        for (int end = 0; end < 2 && !pair.diagonal; ++end)
            open[2 * e + end] = !sameUv(uv, mesh.cornerOfSoup(pair.corner[end][0]),
                                        mesh.cornerOfSoup(pair.corner[end][1]), distance);
    }
    return open;
}

SoupMap SoupMap::of(const MeshData &mesh, const UvMatrix &uv)
{
    return {soupUv(mesh, uv), openCornerPairs(mesh, uv)};
}

} // namespace autocuts
