#include "model/plain/meshadjacency.h"

namespace autocuts {

MeshAdjacency::MeshAdjacency(const MeshData &mesh)
    : mCornerEdge(mesh.cornerCount(), -1), mCornerFace(mesh.cornerCount(), -1)
{
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            mCornerFace[c] = f;
    }
    const auto addEdge = [&](int soupA, int soupB, int faceA, int faceB, double length, bool diagonal) {
        mEdgeVertices.push_back({mesh.vertexOfSoup(soupA), mesh.vertexOfSoup(soupB)});
        mEdgeFaces.push_back({faceA, faceB});
        mEdgeLength.push_back(length);
        mDiagonal.push_back(diagonal);
    };
    for (const EdgePair &pair : mesh.edgePairs) {
        const int edge = edgeCount();
        addEdge(pair.corner[0][0], pair.corner[1][0], mesh.triangleFace[pair.triangle[0]],
                mesh.triangleFace[pair.triangle[1]], pair.length, pair.diagonal);
        if (pair.diagonal)
            continue;
        for (int which = 0; which < 2; ++which)
            mCornerEdge[mesh.triangles[pair.triangle[which]][pair.side(which)]] = edge;
    }
    for (const BoundarySide &side : mesh.boundarySides) {
        const int a = 3 * side.triangle + side.side;
        const int b = 3 * side.triangle + (side.side + 1) % 3;
        mCornerEdge[mesh.cornerOfSoup(a)] = edgeCount();
        addEdge(
            a, b, mesh.triangleFace[side.triangle], -1,
            (mesh.cornerPosition(mesh.cornerOfSoup(a)) - mesh.cornerPosition(mesh.cornerOfSoup(b))).norm(),
            false);
    }
    std::vector<std::pair<int, int>> edgesOfVertices, cornersOfVertices;
    for (int edge = 0; edge < edgeCount(); ++edge) {
        if (isDiagonal(edge))
            continue;
        const auto [a, b] = mEdgeVertices[edge];
        edgesOfVertices.emplace_back(a, edge);
        if (b != a)
            edgesOfVertices.emplace_back(b, edge);
    }
    for (int corner = 0; corner < mesh.cornerCount(); ++corner)
        cornersOfVertices.emplace_back(mesh.vertexWeld[mesh.cornerVertex[corner]], corner);
    mVertexEdges = CsrList(mesh.vertexCount(), edgesOfVertices);
    mVertexCorners = CsrList(mesh.vertexCount(), cornersOfVertices);
}

} // namespace autocuts
