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

//! For every polygon corner the edge of MeshAdjacency that has the side from there to the next corner; -1 on
//! sides along which a polygon meets itself.
std::vector<int> edgesBySide(const MeshData &mesh);

//! The corner at which the side of an edge of MeshAdjacency starts; of the two sides of an edge pair the
//! first. \pre the edge is no diagonal
int sideOfEdge(const MeshData &mesh, int edge);

//! The corner at which the side of a corner pair starts: every corner pair has a side of its own.
//! \pre the corner pair is on no diagonal
int sideOfCornerPair(const MeshData &mesh, int cornerPair);
//! The reverse. \pre the side that starts at the corner is one of the edge pair
int cornerPairOfSide(const MeshData &mesh, int edgePair, int corner);

//! True when the numbers of edges and corner pairs in files of version 1 are certainly those of this mesh:
//! before larger meshes were numbered along a curve, the version was the same.
bool hasNumbersOfVersion1(const MeshData &mesh);

} // namespace autocuts
