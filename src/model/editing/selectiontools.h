// Ways to extend a selection: loops, shortest paths, growing and shrinking, islands and connected components.
// All results are strictly ascending.
#pragma once

#include "model/document/selection.h"
#include "model/plain/meshadjacency.h"

#include <span>
#include <vector>

namespace autocuts {

class Islands;

//! The edge that goes on in the loop of an edge behind one of its vertices; -1 when it ends there.
int nextInLoop(const MeshData &mesh, const MeshAdjacency &adjacency, int edge, int vertex);

//! The edge loop through an edge. Between quads and larger polygons it continues straight at inner vertices
//! with four edges and ends elsewhere. Between triangles it follows the straightest continuation and ends
//! where that turns by more than 60 degrees. Along a boundary it follows the boundary. \pre edge is not a
//! diagonal
std::vector<int> edgeLoop(const MeshData &mesh, const MeshAdjacency &adjacency, int edge);

//! The edges of the shortest path along edges between two welded vertices; empty when there is none or both
//! are the same. \param edgeFactor factor >= 0 on the length of each edge; empty: all 1
std::vector<int> shortestPath(const MeshAdjacency &adjacency, int from, int to,
                              std::span<const double> edgeFactor = {});

//! The selection and its neighbours: faces that share a vertex, edges that share a vertex, or vertices that
//! share an edge, by the selection mode. Islands do not grow.
Selection grown(const MeshData &mesh, const MeshAdjacency &adjacency, const Selection &selection);
//! The selection without the elements that have an unselected neighbour, in the sense of grown().
Selection shrunk(const MeshData &mesh, const MeshAdjacency &adjacency, const Selection &selection);

//! All faces of the islands that contain these faces.
QList<int> facesOfIslands(const Islands &islands, const QList<int> &faces);
//! All faces of the connected components of the mesh that contain these faces.
QList<int> linkedFaces(const MeshData &mesh, const QList<int> &faces);

} // namespace autocuts
