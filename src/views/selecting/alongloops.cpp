#include "views/selecting/alongloops.h"

#include "model/document/document.h"
#include "model/editing/selectiontools.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>

namespace autocuts {

namespace {

//! The sides of quads, and what is behind them. Side k of a face runs from its corner k to the next one.
class Quads
{
public:
    explicit Quads(const Document &document) : mMesh(document.mesh()), mAdjacency(document.adjacency()) {}

    bool isQuad(int face) const { return mMesh.faceStart[face + 1] - mMesh.faceStart[face] == 4; }
    int edge(int face, int side) const { return mAdjacency.edgeOfCorner(mMesh.faceStart[face] + side % 4); }
    //! The face behind a side of a quad; -1 when there is none.
    int behind(int face, int side) const
    {
        const auto [first, second] = mAdjacency.edgeFaces(edge(face, side));
        return first == face ? second : first;
    }
    //! Which side of a quad an edge is.
    int sideOf(int face, int wanted) const
    {
        int side = 0;
        while (side < 3 && edge(face, side) != wanted)
            ++side;
        return side;
    }
    //! The opposite edge in a face; -1 when the face is none, or no quad.
    int opposite(int face, int from) const
    {
        return face >= 0 && isQuad(face) ? edge(face, sideOf(face, from) + 2) : -1;
    }

private:
    const MeshData &mMesh;
    const MeshAdjacency &mAdjacency;
};

template <class Indices>
QList<int> listOf(const Indices &indices)
{
    return QList<int>(indices.begin(), indices.end());
}

Selection ofFaces(const Selection &selection, const std::set<int> &faces)
{
    Selection result;
    result.mode = selection.mode;
    result.faces = listOf(faces);
    return result;
}

Selection ofEdges(const std::set<int> &edges)
{
    Selection result;
    result.mode = SelectionMode::Edges;
    result.edges = listOf(edges);
    return result;
}

int vertexOf(const MeshData &mesh, int corner)
{
    return mesh.vertexWeld[mesh.cornerVertex[corner]];
}

std::set<int> verticesOf(const MeshData &mesh, const Selection &selection)
{
    std::set<int> vertices;
    for (const int corner : selection.corners)
        vertices.insert(vertexOf(mesh, corner));
    return vertices;
}

Selection ofVertices(const Document &document, const std::set<int> &vertices)
{
    Selection result;
    result.mode = SelectionMode::Vertices;
    for (const int vertex : vertices) {
        for (const int corner : document.adjacency().vertexCorners(vertex))
            result.corners.append(corner);
    }
    std::sort(result.corners.begin(), result.corners.end());
    return result;
}

//! The edges that have both ends among the vertices.
std::set<int> edgesBetween(const MeshAdjacency &adjacency, const std::set<int> &vertices)
{
    std::set<int> edges;
    for (const int vertex : vertices) {
        for (const int edge : adjacency.vertexEdges(vertex)) {
            if (vertices.contains(adjacency.otherEnd(edge, vertex)))
                edges.insert(edge);
        }
    }
    return edges;
}

//! Calls visit(face, side) for each side of a selected quad at which a row of selected quads ends.
template <class Visit>
void forEachEndOfStrip(const Quads &quads, const std::set<int> &faces, Visit visit)
{
    const auto isIn = [&](int face) { return face >= 0 && faces.contains(face); };
    for (const int face : faces) {
        for (int side = 0; side < 4 && quads.isQuad(face); ++side) {
            if (isIn(quads.behind(face, side + 2)) && !isIn(quads.behind(face, side)))
                visit(face, side);
        }
    }
}

//! Calls visit(edge, vertex, next) for each end of a row of selected edges. `next`: the edge that goes on
//! there, or -1. \param alone also for edges without a selected neighbour
template <class Visit>
void forEachEndOfLoop(const Document &document, const std::set<int> &edges, bool alone, Visit visit)
{
    const MeshAdjacency &adjacency = document.adjacency();
    for (const int edge : edges) {
        for (const int vertex : adjacency.edgeVertices(edge)) {
            const int next = nextInLoop(document.mesh(), adjacency, edge, vertex);
            const int before = nextInLoop(document.mesh(), adjacency, edge, adjacency.otherEnd(edge, vertex));
            if (!edges.contains(next) && (alone || edges.contains(before)))
                visit(edge, vertex, next);
        }
    }
}

//! Those of the elements that are an even number of steps from the first one of their connected part.
//! \param neighbours of an element; those that are not selected do not matter
template <class Neighbours>
std::set<int> evenOnes(const std::set<int> &elements, Neighbours neighbours)
{
    std::map<int, int> steps;
    std::set<int> even;
    for (const int first : elements) {
        if (!steps.try_emplace(first, 0).second)
            continue;
        std::queue<int> waiting({first});
        while (!waiting.empty()) {
            const int element = waiting.front();
            waiting.pop();
            const int step = steps.at(element);
            if (step % 2 == 0)
                even.insert(element);
            for (const int neighbour : neighbours(element)) {
                if (elements.contains(neighbour) && steps.try_emplace(neighbour, step + 1).second)
                    waiting.push(neighbour);
            }
        }
    }
    return even;
}

std::set<int> setOf(const QList<int> &list)
{
    return {list.begin(), list.end()};
}

//! The edges that share a vertex with an edge, or are opposite to it in a quad.
std::vector<int> edgesBeside(const Document &document, const Quads &quads, int edge)
{
    const MeshAdjacency &adjacency = document.adjacency();
    std::vector<int> beside;
    for (const int vertex : adjacency.edgeVertices(edge)) {
        for (const int other : adjacency.vertexEdges(vertex))
            beside.push_back(other);
    }
    for (const int face : adjacency.edgeFaces(edge)) {
        if (const int other = quads.opposite(face, edge); other >= 0)
            beside.push_back(other);
    }
    return beside;
}

} // namespace

Selection ringsOf(const Document &document, const Selection &selection)
{
    const Quads quads(document);
    std::set<int> found;
    for (const int start : selection.edges) {
        if (!found.insert(start).second)
            continue;
        for (int face : document.adjacency().edgeFaces(start)) {
            int edge = start;
            while ((edge = quads.opposite(face, edge)) >= 0 && found.insert(edge).second)
                face = quads.behind(face, quads.sideOf(face, edge));
        }
    }
    return ofEdges(found);
}

Selection stripsOf(const Document &document, const Selection &selection)
{
    const Quads quads(document);
    const std::set<int> selected = setOf(selection.faces);
    std::set<int> found = selected;
    std::set<std::pair<int, int>> walked; // face, side modulo 2
    const auto isIn = [&](int face, int side) { return selected.contains(quads.behind(face, side)); };
    for (const int start : selected) {
        if (!quads.isQuad(start))
            continue;
        const bool alone = !isIn(start, 0) && !isIn(start, 1) && !isIn(start, 2) && !isIn(start, 3);
        for (int side = 0; side < 4; ++side) {
            if (!alone && !isIn(start, side) && !isIn(start, side + 2))
                continue;
            int face = start, out = side;
            walked.insert({start, side % 2});
            while (true) {
                const int edge = quads.edge(face, out);
                face = quads.behind(face, out);
                if (face < 0 || !quads.isQuad(face))
                    break;
                found.insert(face);
                out = quads.sideOf(face, edge) + 2;
                if (!walked.insert({face, out % 2}).second)
                    break;
            }
        }
    }
    return ofFaces(selection, found);
}

Selection everySecond(const Document &document, const Selection &selection)
{
    const Quads quads(document);
    const MeshData &mesh = document.mesh();
    const MeshAdjacency &adjacency = document.adjacency();
    switch (selection.mode) {
    case SelectionMode::Edges:
        return ofEdges(
            evenOnes(setOf(selection.edges), [&](int edge) { return edgesBeside(document, quads, edge); }));
    case SelectionMode::Vertices:
        return ofVertices(document, evenOnes(verticesOf(mesh, selection), [&](int vertex) {
                              std::vector<int> others;
                              for (const int edge : adjacency.vertexEdges(vertex))
                                  others.push_back(adjacency.otherEnd(edge, vertex));
                              return others;
                          }));
    case SelectionMode::Faces:
        return ofFaces(selection, evenOnes(setOf(selection.faces), [&](int face) {
                           std::vector<int> others;
                           for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
                               for (const int other : adjacency.edgeFaces(adjacency.edgeOfCorner(c)))
                                   others.push_back(other);
                           }
                           return others;
                       }));
    case SelectionMode::Islands:
        break;
    }
    std::set<int> kept;
    const auto islands = document.islands().islandsOf(selection.faces);
    for (const int face : selection.faces) {
        const auto place = std::ranges::find(islands, document.islands().islandOfFace(face));
        if ((place - islands.begin()) % 2 == 0)
            kept.insert(face);
    }
    return ofFaces(selection, kept);
}

Selection grownAlong(const Document &document, const Selection &selection)
{
    const MeshAdjacency &adjacency = document.adjacency();
    if (selection.mode == SelectionMode::Islands)
        return selection;
    if (selection.mode == SelectionMode::Faces) {
        const Quads quads(document);
        const std::set<int> selected = setOf(selection.faces);
        std::set<int> faces = selected;
        forEachEndOfStrip(quads, selected, [&](int face, int side) {
            if (const int next = quads.behind(face, side); next >= 0)
                faces.insert(next);
        });
        return ofFaces(selection, faces);
    }
    const bool ofMode = selection.mode == SelectionMode::Edges;
    std::set<int> vertices = verticesOf(document.mesh(), selection);
    const std::set<int> selected = ofMode ? setOf(selection.edges) : edgesBetween(adjacency, vertices);
    std::set<int> edges = selected;
    forEachEndOfLoop(document, selected, true, [&](int, int vertex, int next) {
        if (next < 0)
            return;
        edges.insert(next);
        vertices.insert(adjacency.otherEnd(next, vertex));
    });
    return ofMode ? ofEdges(edges) : ofVertices(document, vertices);
}

Selection shrunkAlong(const Document &document, const Selection &selection)
{
    if (selection.mode == SelectionMode::Islands)
        return selection;
    if (selection.mode == SelectionMode::Faces) {
        std::set<int> faces = setOf(selection.faces);
        forEachEndOfStrip(Quads(document), setOf(selection.faces), [&](int face, int) { faces.erase(face); });
        return ofFaces(selection, faces);
    }
    const bool ofMode = selection.mode == SelectionMode::Edges;
    std::set<int> vertices = verticesOf(document.mesh(), selection);
    const std::set<int> selected =
        ofMode ? setOf(selection.edges) : edgesBetween(document.adjacency(), vertices);
    std::set<int> edges = selected;
    forEachEndOfLoop(document, selected, !ofMode, [&](int edge, int vertex, int) {
        edges.erase(edge);
        vertices.erase(vertex);
    });
    return ofMode ? ofEdges(edges) : ofVertices(document, vertices);
}

} // namespace autocuts
