#include "views/gl/souptopology.h"

namespace autocuts {

SoupTopology::SoupTopology(const MeshData &mesh) : sideEdge(mesh.soupCornerCount(), -1)
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
}

} // namespace autocuts
