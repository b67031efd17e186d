// Ways to select: loops, paths, growing and shrinking, islands and connected parts. Plain functions of the
// mesh; all results are strictly rising.
#pragma once

#include "model/document/selection.h"
#include "model/plain/meshadjacency.h"

#include <span>
#include <vector>

namespace autocuts {

class Islands;

//! The loop through an edge. Between quads (and polygons) it goes straight on at inner vertices with four
//! edges and ends elsewhere; between triangles it takes the straightest continuation and ends where that
//! turns by more than 60 degrees; along a boundary it follows the boundary. \pre edge is not a diagonal
std::vector<int> edgeLoop(const MeshData &mesh, const MeshAdjacency &adjacency, int edge);

//! The edges of the shortest way along edges between two (welded) vertices; empty when there is none or both
//! are the same. \param edgeFactor factor on the length of each edge, >= 0; empty: all 1
std::vector<int> shortestPath(const MeshAdjacency &adjacency, int from, int to,
                              std::span<const double> edgeFactor = {});

//! The selection and its neighbours, by the mode: faces that share a vertex, edges that share a vertex,
//! vertices that share an edge. Islands do not grow.
Selection grown(const MeshData &mesh, const MeshAdjacency &adjacency, const Selection &selection);
//! The selection without its rim: what has no unselected neighbour in the sense of grown().
Selection shrunk(const MeshData &mesh, const MeshAdjacency &adjacency, const Selection &selection);

//! All faces of the islands that these faces belong to.
QList<int> facesOfIslands(const Islands &islands, const QList<int> &faces);
//! All faces of the connected parts of the mesh that these faces belong to.
QList<int> linkedFaces(const MeshData &mesh, const QList<int> &faces);

} // namespace autocuts
