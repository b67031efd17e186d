// Names for edge pairs that stay valid when a mesh is triangulated differently. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <array>
#include <vector>

namespace autocuts {

//! Names an edge pair by the two polygon sides that it joins. Unlike the number of the pair, this depends
//! neither on how polygons are triangulated nor on the rest of the mesh.
struct SidePair
{
    std::array<int, 2> startCorner; //!< each side runs from this corner to the next one of its polygon
    //! The two corner pairs: the first is at startCorner[0], the second at the other end.
    std::array<int, 2> cornerPair;
};

//! \pre the edge pair is not a diagonal
SidePair sidePair(const MeshData &mesh, int edgePair);

//! For every polygon corner, the edge pair of the side that starts there. -1 on boundaries and on sides along
//! which a polygon meets itself.
std::vector<int> edgePairsBySide(const MeshData &mesh);

//! For every polygon corner, the MeshAdjacency edge of the side that starts there. -1 on sides along which a
//! polygon meets itself.
std::vector<int> edgesBySide(const MeshData &mesh);

//! The corner at which a side of a MeshAdjacency edge starts; the first of the two sides of an edge pair.
//! \pre the edge is not a diagonal
int sideOfEdge(const MeshData &mesh, int edge);

//! The corner that names a corner pair: the start of the side that belongs to its end of the edge.
//! \pre the corner pair is not on a diagonal
int sideOfCornerPair(const MeshData &mesh, int cornerPair);
//! The inverse of sideOfCornerPair(). \pre the side that starts at the corner belongs to the edge pair
int cornerPairOfSide(const MeshData &mesh, int edgePair, int corner);

//! True when edges and corner pairs certainly have the same numbers as in files of version 1. Program
//! versions that wrote version 1 numbered the edges of meshes with 4,096 faces and more in two different
//! ways.
bool hasNumbersOfVersion1(const MeshData &mesh);

} // namespace autocuts
