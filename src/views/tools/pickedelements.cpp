#include "views/tools/pickedelements.h"

#include "model/document/document.h"
#include "model/editing/selectiontools.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/tools/seampath.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace autocuts {

namespace {

//! The faces of the islands to which the faces belong; for faces without UVs, of the connected components.
QList<int> wholeIslands(const Document &document, const QList<int> &faces)
{
    QList<int> withoutUv;
    for (int face : faces) {
        if (document.islands().islandOfFace(face) < 0)
            withoutUv << face;
    }
    QList<int> result = facesOfIslands(document.islands(), faces);
    if (!withoutUv.isEmpty()) {
        result += linkedFaces(document.mesh(), withoutUv);
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
    }
    return result;
}

QList<int> toList(const std::vector<int> &values)
{
    return {values.begin(), values.end()};
}

//! The corners of the vertex of a soup corner; in the map, only those at the same position.
QList<int> cornersOfVertex(const Document &document, const ToolCanvas &canvas, int soupCorner)
{
    const MeshData &mesh = document.mesh();
    const auto corners = document.adjacency().vertexCorners(mesh.vertexOfSoup(soupCorner));
    if (canvas.kind() == ToolCanvas::Kind::Model)
        return {corners.begin(), corners.end()};
    const UvMatrix &uv = canvas.content().uv();
    const double tolerance = 1e-9 * (1 + uv.row(soupCorner).cwiseAbs().maxCoeff());
    QList<int> result;
    for (int corner : corners) {
        const int face = document.adjacency().faceOfCorner(corner);
        for (const int s : mesh.soupCornersOf(face)) {
            if (mesh.cornerOfSoup(s) != corner ||
                !((uv.row(s) - uv.row(soupCorner)).cwiseAbs().maxCoeff() <= tolerance))
                continue;
            result << corner;
            break;
        }
    }
    return result;
}

QList<int> &listOf(Selection &selection)
{
    return selection.mode == SelectionMode::Edges      ? selection.edges
           : selection.mode == SelectionMode::Vertices ? selection.corners
                                                       : selection.faces;
}

QList<int> combined(const QList<int> &current, const QList<int> &elements, Combine combine)
{
    // Toggling a partly selected group adds its other elements.
    const bool takeAway = combine == Combine::Subtract ||
                          (combine == Combine::Toggle &&
                           std::includes(current.begin(), current.end(), elements.begin(), elements.end()));
    QList<int> result;
    if (takeAway)
        std::set_difference(current.begin(), current.end(), elements.begin(), elements.end(),
                            std::back_inserter(result));
    else
        std::set_union(current.begin(), current.end(), elements.begin(), elements.end(),
                       std::back_inserter(result));
    return result;
}

} // namespace

Selection pickedElements(const Document &document, const ToolCanvas &canvas, const PickResult &pick)
{
    Selection picked;
    picked.mode = document.selection().mode;
    switch (picked.mode) {
    case SelectionMode::Vertices:
        if (pick.soupCorner >= 0)
            picked.corners = cornersOfVertex(document, canvas, pick.soupCorner);
        break;
    case SelectionMode::Edges:
        if (pick.edge >= 0)
            picked.edges = {pick.edge};
        break;
    case SelectionMode::Faces:
    case SelectionMode::Islands:
        if (pick.triangle < 0)
            break;
        picked.faces = {document.mesh().triangleFace[pick.triangle]};
        if (picked.mode == SelectionMode::Islands)
            picked.faces = wholeIslands(document, picked.faces);
        break;
    }
    return picked;
}

Selection pickedElements(const Document &document, const BoxPick &box)
{
    Selection picked;
    picked.mode = document.selection().mode;
    switch (picked.mode) {
    case SelectionMode::Vertices:
        picked.corners = toList(box.corners);
        break;
    case SelectionMode::Edges:
        picked.edges = toList(box.edges);
        break;
    case SelectionMode::Faces:
        picked.faces = toList(box.faces);
        break;
    case SelectionMode::Islands:
        picked.faces = wholeIslands(document, toList(box.faces));
        break;
    }
    return picked;
}

Selection pickedGroup(const Document &document, const ToolCanvas &canvas, const PickResult &pick)
{
    Selection picked = pickedElements(document, canvas, pick);
    if (!picked.edges.isEmpty())
        picked.edges = toList(edgeLoop(document.mesh(), document.adjacency(), pick.edge));
    if (!picked.faces.isEmpty())
        picked.faces = picked.mode == SelectionMode::Faces ? wholeIslands(document, picked.faces)
                                                           : linkedFaces(document.mesh(), picked.faces);
    return picked;
}

QList<int> pathBetweenEdges(const Document &document, int from, int to)
{
    return toList(pathBetween(document, {-1, from}, {-1, to}));
}

QList<int> pathBetweenCorners(const Document &document, int from, int to)
{
    const MeshData &mesh = document.mesh();
    const auto vertexOf = [&mesh](int corner) { return mesh.vertexWeld[mesh.cornerVertex[corner]]; };
    const MeshAdjacency &adjacency = document.adjacency();
    std::set<int> corners;
    for (int edge : shortestPath(adjacency, vertexOf(from), vertexOf(to), shownEdgeFactors(document))) {
        for (int vertex : adjacency.edgeVertices(edge))
            corners.insert(adjacency.vertexCorners(vertex).begin(), adjacency.vertexCorners(vertex).end());
    }
    return {corners.begin(), corners.end()};
}

Selection combined(const Selection &current, const Selection &elements, Combine combine)
{
    Selection result;
    result.mode = current.mode;
    Selection picked = elements;
    picked.mode = current.mode;
    if (combine != Combine::Replace) {
        result = current;
        listOf(result) = combined(listOf(result), listOf(picked), combine);
    } else {
        listOf(result) = listOf(picked);
    }
    return result;
}

} // namespace autocuts
