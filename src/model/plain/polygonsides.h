// Names for edge pairs that outlive a mesh. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <array>
#include <vector>

namespace autocuts {

//! An edge pair by the two polygon sides that it joins. Unlike the number of the pair this does not depend on
//! how the polygons are triangulated, nor on the rest of the mesh.
struct SidePair
{
    std::array<int, 2> startCorner; //!< each side runs from this corner to the next one of its polygon
    //! The corner pairs: the first is at startCorner[0], the second at the other end.
    std::array<int, 2> cornerPair;
};

//! \pre the edge pair is no diagonal
SidePair sidePair(const MeshData &mesh, int edgePair);

//! For every polygon corner the edge pair that has the side from there to the next corner; -1 on boundaries
//! and on sides along which a polygon meets itself.
std::vector<int> edgePairsBySide(const MeshData &mesh);

} // namespace autocuts
