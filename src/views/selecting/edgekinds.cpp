#include "views/selecting/edgekinds.h"

#include "model/document/document.h"
#include "model/document/givenseams.h"

#include <algorithm>

namespace autocuts {

namespace {

//! The edge pairs that the options ask for.
QList<int> markedPairs(const Document &document, const GivenSeamOptions &options)
{
    const std::vector<bool> marked =
        givenSeams(document.state().scene, options.map ? &document.uv() : nullptr, {}, options);
    QList<int> edges;
    for (std::size_t pair = 0; pair < marked.size(); ++pair) {
        if (marked[pair])
            edges.append(static_cast<int>(pair));
    }
    return edges;
}

} // namespace

QList<int> sharpEdges(const Document &document, double degrees)
{
    return markedPairs(document, {.cuts = false, .map = false, .sharp = true, .sharpAngle = degrees});
}

QList<int> borderEdges(const Document &document)
{
    const MeshAdjacency &adjacency = document.adjacency();
    QList<int> edges;
    for (int edge = 0; edge < adjacency.edgeCount(); ++edge) {
        if (adjacency.isBoundary(edge))
            edges.append(edge);
    }
    return edges;
}

QList<int> seamEdges(const Document &document)
{
    return markedPairs(document, {.cuts = false, .map = true});
}

QList<int> outlineEdges(const Document &document, const QList<int> &faces)
{
    const MeshAdjacency &adjacency = document.adjacency();
    const auto inside = [&](int face) {
        return face >= 0 && std::binary_search(faces.begin(), faces.end(), face);
    };
    QList<int> edges;
    for (int edge = 0; edge < adjacency.edgeCount(); ++edge) {
        const auto [first, second] = adjacency.edgeFaces(edge);
        if (!adjacency.isDiagonal(edge) && inside(first) != inside(second))
            edges.append(edge);
    }
    return edges;
}

} // namespace autocuts
