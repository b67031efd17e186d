#include "views/gl/souptopology.h"

namespace autocuts {

SoupTopology::SoupTopology(const MeshData &mesh)
    : sideEdge(mesh.soupCornerCount(), -1), faceTriangle(mesh.faceCount() + 1, 0)
{
    edgeSides.reserve(mesh.edgePairs.size() + mesh.boundarySides.size());
    for (const EdgePair &pair : mesh.edgePairs)
        edgeSides.push_back({3 * pair.triangle[0] + pair.side(0), 3 * pair.triangle[1] + pair.side(1)});
    for (const BoundarySide &side : mesh.boundarySides)
        edgeSides.push_back({3 * side.triangle + side.side, -1});
    for (std::size_t edge = 0; edge < edgeSides.size(); ++edge) {
        if (edge < mesh.edgePairs.size() && mesh.edgePairs[edge].diagonal)
            continue;
        for (int side : edgeSides[edge]) {
            if (side >= 0)
                sideEdge[side] = static_cast<int>(edge);
        }
    }
    for (int t = 0; t < mesh.triangleCount(); ++t)
        faceTriangle[mesh.triangleFace[t] + 1] = t + 1;
}

} // namespace autocuts
