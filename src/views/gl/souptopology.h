// Maps sides of soup triangles to edges of the mesh, for drawing and picking.
#pragma once

#include "model/plain/meshdata.h"

#include <array>
#include <vector>

namespace autocuts {

//! Sides and edges. Side 3 * t + k runs from corner k of triangle t to its next corner. Built once per mesh.
struct SoupTopology
{
    explicit SoupTopology(const MeshData &mesh);

    std::vector<int> sideEdge; //!< per side: the edge of MeshAdjacency; -1 for a diagonal
    std::vector<std::array<int, 2>>
        edgeSides; //!< per edge: its two sides in the order of the edge pair, or one side and -1
};

//! The next corner of the same triangle.
inline int nextSoupCorner(int soupCorner)
{
    return soupCorner % 3 == 2 ? soupCorner - 2 : soupCorner + 1;
}

} // namespace autocuts
