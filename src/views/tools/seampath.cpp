#include "views/tools/seampath.h"

#include "model/document/document.h"
#include "model/editing/selectiontools.h"

#include <algorithm>
#include <limits>

namespace autocuts {

namespace {

std::vector<int> verticesOf(const MeshAdjacency &adjacency, const PathEnd &end)
{
    if (end.vertex >= 0)
        return {end.vertex};
    const auto &ends = adjacency.edgeVertices(end.edge);
    return {ends[0], ends[1]};
}

double lengthOf(const MeshAdjacency &adjacency, const std::vector<int> &edges)
{
    double length = 0;
    for (int edge : edges)
        length += adjacency.edgeLength(edge);
    return length;
}

} // namespace

PathEnd pathEnd(const Document &document, const PickResult &pick)
{
    if (pick.soupCorner >= 0)
        return {document.mesh().vertexOfSoup(pick.soupCorner), -1};
    return {-1, pick.edge};
}

std::vector<double> shownEdgeFactors(const Document &document)
{
    const std::vector<bool> &hidden = document.hidden();
    if (hidden.empty())
        return {};
    const MeshAdjacency &adjacency = document.adjacency();
    std::vector<double> factors(static_cast<std::size_t>(adjacency.edgeCount()), 1);
    for (int edge = 0; edge < adjacency.edgeCount(); ++edge) {
        const auto &faces = adjacency.edgeFaces(edge);
        const bool shown = std::any_of(faces.begin(), faces.end(), [&](int face) {
            return face >= 0 && !hidden[static_cast<std::size_t>(face)];
        });
        if (!shown)
            factors[static_cast<std::size_t>(edge)] = std::numeric_limits<double>::infinity();
    }
    return factors;
}

std::vector<int> pathBetween(const Document &document, const PathEnd &from, const PathEnd &to)
{
    if (from.isNone() || to.isNone())
        return {};
    const MeshAdjacency &adjacency = document.adjacency();
    const std::vector<double> factors = shownEdgeFactors(document);
    double shortest = std::numeric_limits<double>::infinity();
    std::vector<int> best;
    for (int start : verticesOf(adjacency, from)) {
        for (int end : verticesOf(adjacency, to)) {
            std::vector<int> path = shortestPath(adjacency, start, end, factors);
            if (path.empty() && start != end)
                continue;
            const double length = lengthOf(adjacency, path);
            if (length < shortest) {
                shortest = length;
                best = std::move(path);
            }
        }
    }
    if (!(shortest < std::numeric_limits<double>::infinity()))
        return {};
    for (int edge : {from.edge, to.edge}) {
        if (edge >= 0)
            best.push_back(edge);
    }
    std::sort(best.begin(), best.end());
    best.erase(std::unique(best.begin(), best.end()), best.end());
    return best;
}

} // namespace autocuts
