#include "model/plain/meshadjacency.h"

namespace autocuts {

namespace {

//! Groups the items 0, 1, ... by key(item) and keeps their order within a group. Items with key -1 are left
//! out.
template <typename Keys>
IndexLists grouped(int listCount, int itemCount, Keys keys)
{
    IndexLists lists;
    lists.start.assign(listCount + 1, 0);
    for (int i = 0; i < itemCount; ++i)
        keys(i, [&](int key) { ++lists.start[key + 1]; });
    for (int list = 0; list < listCount; ++list)
        lists.start[list + 1] += lists.start[list];
    lists.items.resize(lists.start.back());
    std::vector<int> next(lists.start.begin(), lists.start.end() - 1);
    for (int i = 0; i < itemCount; ++i)
        keys(i, [&](int key) { lists.items[next[key]++] = i; });
    return lists;
}

} // namespace

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
    mVertexEdges = grouped(mesh.vertexCount(), edgeCount(), [&](int edge, auto visit) {
        if (isDiagonal(edge))
            return;
        visit(mEdgeVertices[edge][0]);
        if (mEdgeVertices[edge][1] != mEdgeVertices[edge][0])
            visit(mEdgeVertices[edge][1]);
    });
    mVertexCorners = grouped(mesh.vertexCount(), mesh.cornerCount(), [&](int corner, auto visit) {
        visit(mesh.vertexWeld[mesh.cornerVertex[corner]]);
    });
}

} // namespace autocuts
