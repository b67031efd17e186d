#include "views/selecting/similaredges.h"

#include "model/document/document.h"
#include "model/plain/edgeangles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace autocuts {

namespace {

// Chosen by hand, as those of faces.
constexpr double largestLengthFactor = 1.1;
constexpr double largestTurn = 10 * std::numbers::pi / 180;

//! The figures of one edge: one for each side of it that has UVs, or its length on the model.
using EdgeFigures = std::vector<double>;

//! The differences of the UVs at both ends, for each side of each edge that has UVs.
std::vector<std::vector<Vec2>> sidesInMap(const Document &document)
{
    const MeshData &mesh = document.mesh();
    const UvMatrix &uv = document.uv();
    std::vector<std::vector<Vec2>> sides(static_cast<std::size_t>(document.adjacency().edgeCount()));
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int first = mesh.faceStart[face], end = mesh.faceStart[face + 1];
        for (int corner = first; corner < end; ++corner) {
            const Vec2 side = uv.row(corner + 1 < end ? corner + 1 : first) - uv.row(corner);
            if (side.allFinite())
                sides[static_cast<std::size_t>(document.adjacency().edgeOfCorner(corner))].push_back(side);
        }
    }
    return sides;
}

//! Lengths as logarithms, so that equal factors are equal differences; directions as angles in [0, pi).
std::vector<EdgeFigures> figuresOf(const Document &document, EdgeLikeness likeness)
{
    const int count = document.adjacency().edgeCount();
    std::vector<EdgeFigures> figures(static_cast<std::size_t>(count));
    if (likeness == EdgeLikeness::Length) {
        for (int edge = 0; edge < count; ++edge)
            figures[static_cast<std::size_t>(edge)] = {std::log(document.adjacency().edgeLength(edge))};
        return figures;
    }
    const std::vector<std::vector<Vec2>> sides = sidesInMap(document);
    for (std::size_t edge = 0; edge < sides.size(); ++edge) {
        for (const Vec2 &side : sides[edge]) {
            if (likeness == EdgeLikeness::LengthInMap)
                figures[edge].push_back(std::log(side.norm()));
            else if (side.norm() > 0)
                figures[edge].push_back(
                    std::fmod(std::atan2(side.y(), side.x()) + 2 * std::numbers::pi, std::numbers::pi));
        }
    }
    return figures;
}

} // namespace

QList<int> similarEdges(const Document &document, const QList<int> &edges, EdgeLikeness likeness)
{
    const std::vector<EdgeFigures> figures = figuresOf(document, likeness);
    const bool turns = likeness == EdgeLikeness::DirectionInMap;
    const double largest = turns ? largestTurn : std::log(largestLengthFactor);
    std::vector<double> wanted;
    for (const int edge : edges) {
        for (const double figure : figures[static_cast<std::size_t>(edge)]) {
            wanted.push_back(figure);
            if (turns) { // the directions go round
                wanted.push_back(figure - std::numbers::pi);
                wanted.push_back(figure + std::numbers::pi);
            }
        }
    }
    std::sort(wanted.begin(), wanted.end());
    const auto isWanted = [&](double figure) {
        const auto least = std::lower_bound(wanted.begin(), wanted.end(), figure - largest);
        return least != wanted.end() && *least <= figure + largest;
    };
    QList<int> alike, result;
    for (int edge = 0; edge < document.adjacency().edgeCount(); ++edge) {
        if (!document.adjacency().isDiagonal(edge) &&
            std::ranges::any_of(figures[static_cast<std::size_t>(edge)], isWanted))
            alike.append(edge);
    }
    // Rounding must not leave one of the given edges out.
    std::set_union(alike.begin(), alike.end(), edges.begin(), edges.end(), std::back_inserter(result));
    return result;
}

QList<int> flatFaces(const Document &document, const QList<int> &faces, double degrees)
{
    const MeshData &mesh = document.mesh();
    const MeshAdjacency &adjacency = document.adjacency();
    const std::vector<double> angles = edgeAngles(mesh);
    const double largest = degrees * std::numbers::pi / 180;
    std::vector<bool> found(static_cast<std::size_t>(mesh.faceCount()), false);
    std::vector<int> waiting(faces.begin(), faces.end());
    for (const int face : faces)
        found[static_cast<std::size_t>(face)] = true;
    while (!waiting.empty()) {
        const int face = waiting.back();
        waiting.pop_back();
        for (int corner = mesh.faceStart[face]; corner < mesh.faceStart[face + 1]; ++corner) {
            const int edge = adjacency.edgeOfCorner(corner);
            if (adjacency.isBoundary(edge) || !(angles[static_cast<std::size_t>(edge)] <= largest))
                continue;
            for (const int other : adjacency.edgeFaces(edge)) {
                if (!found[static_cast<std::size_t>(other)]) {
                    found[static_cast<std::size_t>(other)] = true;
                    waiting.push_back(other);
                }
            }
        }
    }
    QList<int> result;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (found[static_cast<std::size_t>(face)])
            result.append(face);
    }
    return result;
}

} // namespace autocuts
