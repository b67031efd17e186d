#include "model/plain/polygonsides.h"

namespace autocuts {

SidePair sidePair(const MeshData &mesh, int edgePair)
{
    const EdgePair &pair = mesh.edgePairs[static_cast<std::size_t>(edgePair)];
    const int start = 3 * pair.triangle[0] + pair.side(0);
    const int end = pair.corner[0][0] == start ? 0 : 1;
    return {{mesh.cornerOfSoup(start), mesh.cornerOfSoup(3 * pair.triangle[1] + pair.side(1))},
            {2 * edgePair + end, 2 * edgePair + 1 - end}};
}

std::vector<int> edgePairsBySide(const MeshData &mesh)
{
    std::vector<int> result(static_cast<std::size_t>(mesh.cornerCount()), -1);
    for (int p = 0; p < static_cast<int>(mesh.edgePairs.size()); ++p) {
        if (mesh.edgePairs[static_cast<std::size_t>(p)].diagonal)
            continue;
        for (int corner : sidePair(mesh, p).startCorner)
            result[static_cast<std::size_t>(corner)] = p;
    }
    return result;
}

} // namespace autocuts
