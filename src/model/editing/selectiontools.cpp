#include "model/editing/selectiontools.h"

#include "model/document/islands.h"
#include "model/plain/nearestfirst.h"

#include <algorithm>
#include <limits>
#include <set>

namespace autocuts {

namespace {

bool isTriangle(const MeshData &mesh, int face)
{
    return mesh.faceStart[face + 1] - mesh.faceStart[face] == 3;
}

//! True when all faces of an edge are triangles.
bool betweenTriangles(const MeshData &mesh, const MeshAdjacency &adjacency, int edge)
{
    const auto &faces = adjacency.edgeFaces(edge);
    return isTriangle(mesh, faces[0]) && (faces[1] < 0 || isTriangle(mesh, faces[1]));
}

//! The other boundary edge at the vertex; -1 unless there is exactly one.
int nextOnBoundary(const MeshAdjacency &adjacency, int edge, int vertex)
{
    int next = -1;
    for (int other : adjacency.vertexEdges(vertex)) {
        if (other == edge || !adjacency.isBoundary(other))
            continue;
        if (next >= 0)
            return -1;
        next = other;
    }
    return next;
}

//! At an inner vertex with four edges, the edge that has no face in common with the given one.
int oppositeEdge(const MeshAdjacency &adjacency, int edge, int vertex)
{
    const auto edges = adjacency.vertexEdges(vertex);
    if (edges.size() != 4)
        return -1;
    int next = -1;
    for (int other : edges) {
        if (adjacency.isBoundary(other))
            return -1;
        const auto &a = adjacency.edgeFaces(edge);
        const auto &b = adjacency.edgeFaces(other);
        if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) == a.end())
            next = other;
    }
    return next;
}

//! The inner edge that continues straightest, with a turn of at most 60 degrees.
int straightestEdge(const MeshData &mesh, const MeshAdjacency &adjacency, int edge, int vertex)
{
    const auto direction = [&](int from, int to) {
        return Vec3((mesh.positions.row(to) - mesh.positions.row(from)).transpose().stableNormalized());
    };
    const Vec3 ahead = direction(adjacency.otherEnd(edge, vertex), vertex);
    int next = -1;
    double best = 0.5 - 1e-9; // cosine of 60 degrees, with room for rounding in a regular triangulation
    for (int other : adjacency.vertexEdges(vertex)) {
        if (other == edge || adjacency.isBoundary(other))
            continue;
        const double straightness = ahead.dot(direction(vertex, adjacency.otherEnd(other, vertex)));
        if (straightness > best) {
            best = straightness;
            next = other;
        }
    }
    return next;
}

template <typename Container>
QList<int> toList(const Container &values)
{
    return QList<int>(values.begin(), values.end());
}

//! Marks the vertices of the selected elements, or those of the elements that are not selected.
std::vector<bool> touchedVertices(const MeshData &mesh, const MeshAdjacency &adjacency,
                                  const Selection &selection, bool ofSelected)
{
    std::vector<bool> touched(mesh.vertexCount(), false);
    if (selection.mode == SelectionMode::Edges) {
        std::vector<bool> selected(adjacency.edgeCount(), false);
        for (int edge : selection.edges)
            selected[edge] = true;
        for (int edge = 0; edge < adjacency.edgeCount(); ++edge) {
            if (selected[edge] != ofSelected || adjacency.isDiagonal(edge))
                continue;
            for (int vertex : adjacency.edgeVertices(edge))
                touched[vertex] = true;
        }
        return touched;
    }
    std::vector<bool> selected(mesh.faceCount(), false);
    for (int face : selection.faces)
        selected[face] = true;
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        if (selected[adjacency.faceOfCorner(c)] == ofSelected)
            touched[mesh.vertexWeld[mesh.cornerVertex[c]]] = true;
    }
    return touched;
}

bool touchesFace(const MeshData &mesh, int face, const std::vector<bool> &vertices)
{
    for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
        if (vertices[mesh.vertexWeld[mesh.cornerVertex[c]]])
            return true;
    }
    return false;
}

std::vector<bool> selectedVertices(const MeshData &mesh, const Selection &selection)
{
    std::vector<bool> selected(mesh.vertexCount(), false);
    for (int corner : selection.corners)
        selected[mesh.vertexWeld[mesh.cornerVertex[corner]]] = true;
    return selected;
}

bool hasNeighbour(const MeshAdjacency &adjacency, const std::vector<bool> &selected, int vertex, bool wanted)
{
    const auto edges = adjacency.vertexEdges(vertex);
    return std::any_of(edges.begin(), edges.end(),
                       [&](int edge) { return selected[adjacency.otherEnd(edge, vertex)] == wanted; });
}

} // namespace

int nextInLoop(const MeshData &mesh, const MeshAdjacency &adjacency, int edge, int vertex)
{
    if (adjacency.isBoundary(edge))
        return nextOnBoundary(adjacency, edge, vertex);
    if (betweenTriangles(mesh, adjacency, edge))
        return straightestEdge(mesh, adjacency, edge, vertex);
    return oppositeEdge(adjacency, edge, vertex);
}

std::vector<int> edgeLoop(const MeshData &mesh, const MeshAdjacency &adjacency, int edge)
{
    std::set<int> loop{edge};
    for (int vertex : adjacency.edgeVertices(edge)) {
        int current = edge;
        while (true) {
            current = nextInLoop(mesh, adjacency, current, vertex);
            if (current < 0 || !loop.insert(current).second)
                break;
            vertex = adjacency.otherEnd(current, vertex);
        }
    }
    return {loop.begin(), loop.end()};
}

std::vector<int> shortestPath(const MeshAdjacency &adjacency, int from, int to,
                              std::span<const double> edgeFactor)
{
    std::vector<double> distance(adjacency.vertexCount(), std::numeric_limits<double>::infinity());
    std::vector<int> via(adjacency.vertexCount(), -1); // the last edge of the path to a vertex
    NearestFirst queue(distance);
    queue.reach(from, 0);
    for (int vertex = queue.next(); vertex >= 0 && vertex != to; vertex = queue.next()) {
        for (int edge : adjacency.vertexEdges(vertex)) {
            const double factor = edgeFactor.empty() ? 1.0 : edgeFactor[edge];
            const int other = adjacency.otherEnd(edge, vertex);
            if (queue.reach(other, distance[vertex] + factor * adjacency.edgeLength(edge)))
                via[other] = edge;
        }
    }
    std::vector<int> path;
    for (int vertex = to; vertex != from;) {
        const int edge = via[vertex];
        if (edge < 0)
            return {};
        path.push_back(edge);
        vertex = adjacency.otherEnd(edge, vertex);
    }
    std::sort(path.begin(), path.end());
    return path;
}

Selection grown(const MeshData &mesh, const MeshAdjacency &adjacency, const Selection &selection)
{
    Selection result = selection;
    if (selection.mode == SelectionMode::Vertices) {
        const std::vector<bool> selected = selectedVertices(mesh, selection);
        for (int c = 0; c < mesh.cornerCount(); ++c) {
            if (hasNeighbour(adjacency, selected, mesh.vertexWeld[mesh.cornerVertex[c]], true))
                result.corners.push_back(c);
        }
    } else if (selection.mode == SelectionMode::Edges) {
        const std::vector<bool> near = touchedVertices(mesh, adjacency, selection, true);
        for (int edge = 0; edge < adjacency.edgeCount(); ++edge) {
            if (near[adjacency.edgeVertices(edge)[0]] || near[adjacency.edgeVertices(edge)[1]])
                result.edges.push_back(edge);
        }
    } else if (selection.mode == SelectionMode::Faces) {
        const std::vector<bool> near = touchedVertices(mesh, adjacency, selection, true);
        for (int face = 0; face < mesh.faceCount(); ++face) {
            if (touchesFace(mesh, face, near))
                result.faces.push_back(face);
        }
    }
    result.normalize(mesh);
    return result;
}

Selection shrunk(const MeshData &mesh, const MeshAdjacency &adjacency, const Selection &selection)
{
    Selection result = selection;
    if (selection.mode == SelectionMode::Vertices) {
        const std::vector<bool> selected = selectedVertices(mesh, selection);
        result.corners.removeIf([&](int corner) {
            return hasNeighbour(adjacency, selected, mesh.vertexWeld[mesh.cornerVertex[corner]], false);
        });
    } else if (selection.mode == SelectionMode::Edges) {
        const std::vector<bool> rim = touchedVertices(mesh, adjacency, selection, false);
        result.edges.removeIf([&](int edge) {
            return rim[adjacency.edgeVertices(edge)[0]] || rim[adjacency.edgeVertices(edge)[1]];
        });
    } else if (selection.mode == SelectionMode::Faces) {
        const std::vector<bool> rim = touchedVertices(mesh, adjacency, selection, false);
        result.faces.removeIf([&](int face) { return touchesFace(mesh, face, rim); });
    }
    return result;
}

QList<int> facesOfIslands(const Islands &islands, const QList<int> &faces)
{
    QList<int> result;
    for (int island : islands.islandsOf(faces))
        result.append(toList(islands.faces(island)));
    std::sort(result.begin(), result.end());
    return result;
}

QList<int> linkedFaces(const MeshData &mesh, const QList<int> &faces)
{
    std::vector<int> componentOfFace(mesh.faceCount());
    for (int t = 0; t < mesh.triangleCount(); ++t)
        componentOfFace[mesh.triangleFace[t]] = mesh.component[t];
    std::vector<bool> wanted(mesh.componentCount, false);
    for (int face : faces)
        wanted[componentOfFace[face]] = true;
    QList<int> result;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (wanted[componentOfFace[face]])
            result.push_back(face);
    }
    return result;
}

} // namespace autocuts
