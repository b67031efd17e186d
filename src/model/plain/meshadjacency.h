// Adjacency of vertices, edges and faces of a mesh, for selecting. Plain: no Qt.
//
// Terms. A *vertex* is a welded vertex (MeshData::vertexWeld). An *edge* is a side of a polygon. Edges are
// numbered: first all edge pairs in their order, then all boundary sides. A number below edgePairs.size() is
// therefore an edge pair. Diagonals keep their numbers, but no list of this class contains one. On a
// non-manifold edge, the edge pair and the sides without a partner are separate edges between the same
// vertices.
#pragma once

#include "model/plain/csrlist.h"
#include "model/plain/meshdata.h"

#include <array>
#include <span>
#include <vector>

namespace autocuts {

//! Adjacency of vertices, edges and faces; built once per mesh.
class MeshAdjacency
{
public:
    explicit MeshAdjacency(const MeshData &mesh);

    int vertexCount() const { return mVertexEdges.size(); }
    int edgeCount() const { return static_cast<int>(mEdgeVertices.size()); }
    bool isDiagonal(int edge) const { return mDiagonal[edge]; }
    //! True when the edge has only one face.
    bool isBoundary(int edge) const { return mEdgeFaces[edge][1] < 0; }
    //! The two end vertices; equal for a side of length zero.
    const std::array<int, 2> &edgeVertices(int edge) const { return mEdgeVertices[edge]; }
    //! The other end of an edge. \pre vertex is an end of the edge
    int otherEnd(int edge, int vertex) const
    {
        return mEdgeVertices[edge][0] == vertex ? mEdgeVertices[edge][1] : mEdgeVertices[edge][0];
    }
    //! The faces on both sides, the second one -1 on a boundary.
    const std::array<int, 2> &edgeFaces(int edge) const { return mEdgeFaces[edge]; }
    double edgeLength(int edge) const { return mEdgeLength[edge]; }

    //! The edge from a corner to the next corner of its polygon.
    int edgeOfCorner(int corner) const { return mCornerEdge[corner]; }
    //! Edges that end at a vertex, in ascending order.
    std::span<const int> vertexEdges(int vertex) const { return mVertexEdges[vertex]; }
    //! Corners at a vertex, in ascending order.
    std::span<const int> vertexCorners(int vertex) const { return mVertexCorners[vertex]; }
    //! All corners, grouped by vertex.
    const std::vector<int> &cornersByVertex() const { return mVertexCorners.values(); }
    int faceOfCorner(int corner) const { return mCornerFace[corner]; }

private:
    std::vector<std::array<int, 2>> mEdgeVertices, mEdgeFaces;
    std::vector<double> mEdgeLength;
    std::vector<bool> mDiagonal;
    std::vector<int> mCornerEdge, mCornerFace;
    CsrList mVertexEdges, mVertexCorners;
};

} // namespace autocuts
