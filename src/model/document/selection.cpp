#include "model/document/selection.h"

#include "model/document/constraints.h"

#include <algorithm>

namespace autocuts {

namespace {

int edgeCount(const MeshData &mesh)
{
    return static_cast<int>(mesh.edgePairs.size() + mesh.boundarySides.size());
}

bool isDiagonal(const MeshData &mesh, int edge)
{
    return edge < static_cast<int>(mesh.edgePairs.size()) && mesh.edgePairs[edge].diagonal;
}

void normalizeList(QList<int> &list, int count)
{
    if (isIndexSet(list, count))
        return; // so that shared storage stays shared
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    list.removeIf([&](int i) { return i < 0 || i >= count; });
}

} // namespace

void Selection::normalize(const MeshData &mesh)
{
    normalizeList(faces, mesh.faceCount());
    normalizeList(edges, edgeCount(mesh));
    normalizeList(corners, mesh.cornerCount());
    const auto diagonal = [&](int edge) { return isDiagonal(mesh, edge); };
    if (std::any_of(edges.cbegin(), edges.cend(), diagonal))
        edges.removeIf(diagonal);
}

void Selection::removeHidden(const MeshData &mesh, const std::vector<bool> &hidden)
{
    if (hidden.empty())
        return;
    const int pairCount = static_cast<int>(mesh.edgePairs.size());
    const auto hidesTriangle = [&](int triangle) { return hidden[mesh.triangleFace[triangle]]; };
    const auto hidesEdge = [&](int edge) {
        if (edge >= pairCount)
            return bool(hidesTriangle(mesh.boundarySides[edge - pairCount].triangle));
        const auto &triangles = mesh.edgePairs[edge].triangle;
        return hidesTriangle(triangles[0]) && hidesTriangle(triangles[1]);
    };
    const auto hidesCorner = [&](int corner) {
        const auto next = std::upper_bound(mesh.faceStart.begin(), mesh.faceStart.end(), corner);
        return bool(hidden[next - mesh.faceStart.begin() - 1]);
    };
    const auto remove = [](QList<int> &list, const auto &hides) {
        if (std::any_of(list.cbegin(), list.cend(), hides)) // so that shared storage stays shared
            list.removeIf(hides);
    };
    remove(faces, [&](int face) { return bool(hidden[face]); });
    remove(edges, hidesEdge);
    remove(corners, hidesCorner);
}

QString Selection::validate(const MeshData &mesh) const
{
    if (mode < SelectionMode::Vertices || mode > SelectionMode::Islands)
        return QStringLiteral("The selection mode is unknown");
    if (!isIndexSet(faces, mesh.faceCount()) || !isIndexSet(edges, edgeCount(mesh)) ||
        !isIndexSet(corners, mesh.cornerCount()))
        return QStringLiteral("The selection does not fit the mesh");
    if (std::any_of(edges.begin(), edges.end(), [&](int edge) { return isDiagonal(mesh, edge); }))
        return QStringLiteral("A diagonal is selected");
    return {};
}

} // namespace autocuts
