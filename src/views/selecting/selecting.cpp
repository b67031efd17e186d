#include "views/selecting/selecting.h"

#include "model/document/document.h"
#include "model/editing/selectiontools.h"
#include "model/editing/similarislands.h"
#include "model/plain/flippedtriangles.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <numeric>

namespace autocuts {

namespace {

//! The indices of the marked elements.
QList<int> indicesOf(const std::vector<bool> &marked)
{
    QList<int> result;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (marked[i])
            result.append(static_cast<int>(i));
    }
    return result;
}

std::vector<bool> marksOf(const QList<int> &indices, int count)
{
    std::vector<bool> marked(count, false);
    for (int index : indices)
        marked[index] = true;
    return marked;
}

//! The edges for which `accept` is true of how many of their faces are given.
template <typename Accept>
QList<int> edgesByFaces(const Document &document, const QList<int> &faces, Accept accept)
{
    const MeshAdjacency &adjacency = document.adjacency();
    const std::vector<bool> inside = marksOf(faces, document.mesh().faceCount());
    QList<int> result;
    for (int edge = 0; edge < adjacency.edgeCount(); ++edge) {
        if (adjacency.isDiagonal(edge))
            continue;
        const auto [first, second] = adjacency.edgeFaces(edge);
        const int count = int(inside[first]) + int(second >= 0 && inside[second]);
        if (accept(count, second >= 0))
            result.append(edge);
    }
    return result;
}

} // namespace

QList<int> facesOf(const Document &document, const Selection &selection)
{
    std::vector<bool> faces = marksOf(selection.faces, document.mesh().faceCount());
    const MeshAdjacency &adjacency = document.adjacency();
    for (int edge : selection.edges) {
        for (int face : adjacency.edgeFaces(edge)) {
            if (face >= 0)
                faces[face] = true;
        }
    }
    for (int corner : selection.corners)
        faces[adjacency.faceOfCorner(corner)] = true;
    return indicesOf(faces);
}

QList<int> cornersOf(const Document &document, const Selection &selection)
{
    const MeshData &mesh = document.mesh();
    std::vector<bool> corners = marksOf(selection.corners, mesh.cornerCount());
    const MeshAdjacency &adjacency = document.adjacency();
    for (int edge : selection.edges) {
        for (int vertex : adjacency.edgeVertices(edge)) {
            for (int corner : adjacency.vertexCorners(vertex))
                corners[corner] = true;
        }
    }
    for (int face : selection.faces)
        std::fill(corners.begin() + mesh.faceStart[face], corners.begin() + mesh.faceStart[face + 1], true);
    return indicesOf(corners);
}

Selection selectionOf(const Document &document, const QList<int> &faces, SelectionMode mode)
{
    Selection result;
    result.mode = mode;
    if (mode == SelectionMode::Edges) {
        result.edges = edgesByFaces(document, faces, [](int count, bool) { return count > 0; });
    } else if (mode == SelectionMode::Vertices) {
        Selection asFaces;
        asFaces.faces = faces;
        result.corners = cornersOf(document, asFaces);
    } else {
        result.faces = faces;
    }
    return result;
}

Selection everything(const Document &document, SelectionMode mode)
{
    QList<int> faces(document.mesh().faceCount());
    std::iota(faces.begin(), faces.end(), 0);
    return selectionOf(document, faces, mode);
}

Selection inverted(const Document &document, const Selection &selection)
{
    const auto without = [](const QList<int> &all, const QList<int> &some) {
        QList<int> rest;
        std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
        return rest;
    };
    const Selection all = everything(document, selection.mode);
    Selection result;
    result.mode = selection.mode;
    result.faces = without(all.faces, selection.faces);
    result.edges = without(all.edges, selection.edges);
    result.corners = without(all.corners, selection.corners);
    return result;
}

Selection loopsOf(const Document &document, const Selection &selection)
{
    const MeshAdjacency &adjacency = document.adjacency();
    std::vector<bool> edges = marksOf(selection.edges, adjacency.edgeCount());
    std::vector<bool> found = edges;
    for (int edge : selection.edges) {
        // The edges of a loop that was found already lead to the same loop.
        if (!edges[edge])
            continue;
        for (int other : edgeLoop(document.mesh(), adjacency, edge)) {
            found[other] = true;
            edges[other] = false;
        }
    }
    Selection result;
    result.mode = SelectionMode::Edges;
    result.edges = indicesOf(found);
    return result;
}

QList<int> facesOfSimilarIslands(const Document &document, const QList<int> &faces)
{
    const Islands &islands = document.islands();
    std::vector<bool> chosen(islands.count(), false);
    for (int island : islands.islandsOf(faces)) {
        if (chosen[island])
            continue;
        for (int copy :
             similarIslands(document.mesh(), document.adjacency(), islands, island, Similarity::Shape))
            chosen[copy] = true;
    }
    QList<int> result;
    for (int face = 0; face < islands.faceCount(); ++face) {
        if (const int island = islands.islandOfFace(face); island >= 0 && chosen[island])
            result.append(face);
    }
    return result;
}

QList<int> flippedFaces(const Document &document)
{
    const MeshData &mesh = document.mesh();
    std::vector<int> islands(mesh.faceCount());
    for (int face = 0; face < mesh.faceCount(); ++face)
        islands[face] = document.islands().islandOfFace(face);
    const std::vector<bool> triangles = flippedTriangles(mesh, document.soupMap().uv, islands);
    std::vector<bool> flipped(mesh.faceCount(), false);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (triangles[t])
            flipped[mesh.triangleFace[t]] = true;
    }
    return indicesOf(flipped);
}

QList<int> edgesToCut(const Document &document, const Selection &selection)
{
    if (!selection.edges.isEmpty())
        return selection.edges;
    return edgesByFaces(document, selection.faces, [](int count, bool inner) { return inner && count == 1; });
}

QList<int> edgesToJoin(const Document &document, const Selection &selection)
{
    if (!selection.edges.isEmpty())
        return selection.edges;
    return edgesByFaces(document, selection.faces, [](int count, bool) { return count == 2; });
}

QList<int> edgesToClear(const Document &document, const Selection &selection)
{
    if (!selection.edges.isEmpty())
        return selection.edges;
    return edgesByFaces(document, selection.faces, [](int count, bool inner) { return inner && count > 0; });
}

} // namespace autocuts
