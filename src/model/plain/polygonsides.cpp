#include "model/plain/polygonsides.h"

#include "model/plain/spatialorder.h"

#include <algorithm>

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

std::vector<int> edgesBySide(const MeshData &mesh)
{
    std::vector<int> result = edgePairsBySide(mesh);
    int edge = static_cast<int>(mesh.edgePairs.size());
    for (const BoundarySide &side : mesh.boundarySides)
        result[static_cast<std::size_t>(mesh.cornerOfSoup(3 * side.triangle + side.side))] = edge++;
    return result;
}

int sideOfEdge(const MeshData &mesh, int edge)
{
    const int pairs = static_cast<int>(mesh.edgePairs.size());
    if (edge < pairs)
        return sidePair(mesh, edge).startCorner[0];
    const BoundarySide &side = mesh.boundarySides[static_cast<std::size_t>(edge - pairs)];
    return mesh.cornerOfSoup(3 * side.triangle + side.side);
}

int sideOfCornerPair(const MeshData &mesh, int cornerPair)
{
    const SidePair sides = sidePair(mesh, cornerPair / 2);
    return sides.startCorner[sides.cornerPair[0] == cornerPair ? 0 : 1];
}

int cornerPairOfSide(const MeshData &mesh, int edgePair, int corner)
{
    const SidePair sides = sidePair(mesh, edgePair);
    return sides.cornerPair[sides.startCorner[0] == corner ? 0 : 1];
}

bool hasNumbersOfVersion1(const MeshData &mesh)
{
    return mesh.faceCount() < std::min(4096, spatiallyNumberedFaces);
}

} // namespace autocuts
