#include "model/transfer/facematch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace autocuts {

namespace {

using Cell = std::array<double, 3>;

double largestCoordinate(const MeshData &mesh)
{
    return mesh.positions.size() == 0 ? 0 : mesh.positions.cwiseAbs().maxCoeff();
}

//! A grid of the welded vertices, with cells as wide as the tolerance.
class VertexGrid
{
public:
    VertexGrid(const MeshData &mesh, double tolerance) : mMesh(mesh), mTolerance(tolerance)
    {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.vertexWeld[v] == v)
                mVertices.emplace_back(cellOf(mesh.positions.row(v)), v);
        }
        std::sort(mVertices.begin(), mVertices.end());
    }

    //! The nearest vertex within the tolerance; the first among equally near ones, -1 when there is none.
    int nearest(const Vec3 &point) const
    {
        int best = -1;
        double bestDistance = mTolerance;
        eachNear(point, [&](int vertex, double distance) {
            if (distance < bestDistance || (distance == bestDistance && (best < 0 || vertex < best))) {
                best = vertex;
                bestDistance = distance;
            }
        });
        return best;
    }

    //! For each vertex the first one of those that are the same within the tolerance, or lead to it.
    std::vector<int> firstOfEqual() const
    {
        std::vector<int> first(static_cast<std::size_t>(mMesh.vertexCount()), -1);
        for (const auto &[cell, start] : mVertices) {
            std::vector<int> open{start};
            while (!open.empty()) {
                const int vertex = open.back();
                open.pop_back();
                if (first[vertex] >= 0)
                    continue;
                first[vertex] = start;
                eachNear(mMesh.positions.row(vertex), [&](int other, double) {
                    if (first[other] < 0)
                        open.push_back(other);
                });
            }
        }
        for (int v = 0; v < mMesh.vertexCount(); ++v)
            first[v] = first[mMesh.vertexWeld[v]];
        return first;
    }

private:
    //! Calls use() with each vertex within the tolerance and its distance.
    template <typename Use>
    void eachNear(const Vec3 &point, Use &&use) const
    {
        const Cell centre = cellOf(point);
        for (int i = 0; i < 27; ++i) {
            const Cell cell{centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1};
            auto it = std::lower_bound(mVertices.begin(), mVertices.end(), std::pair(cell, -1));
            for (; it != mVertices.end() && it->first == cell; ++it) {
                const double distance = (Vec3(mMesh.positions.row(it->second)) - point).norm();
                if (distance <= mTolerance)
                    use(it->second, distance);
            }
        }
    }

    Cell cellOf(const Vec3 &p) const
    {
        if (!(mTolerance > 0))
            return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
        return {std::floor(p.x() / mTolerance), std::floor(p.y() / mTolerance),
                std::floor(p.z() / mTolerance)};
    }

    const MeshData &mMesh;
    double mTolerance;
    std::vector<std::pair<Cell, int>> mVertices;
};

//! The vertices of a face, starting at the corner `first` that gives the lexicographically smallest list.
struct FaceKey
{
    std::vector<int> vertices;
    int first = 0;
};

//! \param vertexOf -1 for a vertex that no key may contain
template <typename VertexOf>
FaceKey faceKey(const MeshData &mesh, int face, VertexOf &&vertexOf)
{
    const int start = mesh.faceStart[face];
    const int count = mesh.faceStart[face + 1] - start;
    std::vector<int> vertices;
    for (int c = start; c < start + count; ++c)
        vertices.push_back(vertexOf(mesh.cornerVertex[c]));
    const int lowest = *std::min_element(vertices.begin(), vertices.end());
    FaceKey key;
    for (int i = 0; i < count; ++i) {
        if (vertices[i] != lowest)
            continue;
        std::vector<int> turned(vertices.begin() + i, vertices.end());
        turned.insert(turned.end(), vertices.begin(), vertices.begin() + i);
        if (key.vertices.empty() || turned < key.vertices)
            key = {std::move(turned), i};
    }
    return key;
}

//! Of faces with the same vertices.
enum class Several {
    InOrder, //!< each gets one, the first one of the same object at first
    None     //!< none is matched, nor faces that have a vertex twice: which one is meant cannot be told
};

bool hasTwice(std::vector<int> vertices)
{
    std::ranges::sort(vertices);
    return std::ranges::adjacent_find(vertices) != vertices.end();
}

//! Matches the faces without counterparts that have the same vertices.
//! \param counterpart for vertices of the old mesh, -1 for none \param same for vertices of the new one
void matchByVertices(const MeshData &before, const MeshData &after, const std::vector<int> &counterpart,
                     const std::vector<int> &same, Several several, FaceMatch &match)
{
    std::vector<bool> taken(static_cast<std::size_t>(after.faceCount()), false);
    for (const int face : match.face) {
        if (face >= 0)
            taken[face] = true;
    }
    std::map<std::vector<int>, std::vector<std::pair<int, int>>> faces; // face and first corner
    for (int f = 0; f < after.faceCount(); ++f) {
        if (taken[f])
            continue;
        FaceKey key = faceKey(after, f, [&](int v) { return same[v]; });
        if (several == Several::None && hasTwice(key.vertices))
            continue;
        faces[std::move(key.vertices)].emplace_back(f, key.first);
    }
    for (int f = 0; f < before.faceCount() && !faces.empty(); ++f) {
        if (match.face[f] >= 0)
            continue;
        const FaceKey key = faceKey(before, f, [&](int v) { return counterpart[v]; });
        const auto found = key.vertices.front() < 0 ? faces.end() : faces.find(key.vertices);
        if (found == faces.end() || found->second.empty() ||
            (several == Several::None && found->second.size() > 1))
            continue;
        auto &candidates = found->second;
        const auto sameObject =
            std::find_if(candidates.begin(), candidates.end(), [&](const auto &candidate) {
                return after.faceObject[candidate.first] == before.faceObject[f];
            });
        const auto chosen = sameObject == candidates.end() ? candidates.begin() : sameObject;
        const int count = static_cast<int>(key.vertices.size());
        match.face[f] = chosen->first;
        for (int i = 0; i < count; ++i)
            match.corner[before.faceStart[f] + (key.first + i) % count] =
                after.faceStart[chosen->first] + (chosen->second + i) % count;
        candidates.erase(chosen);
    }
}

void matchByPosition(const MeshData &before, const MeshData &after, double relativeTolerance,
                     FaceMatch &match)
{
    const double tolerance =
        relativeTolerance * std::max(largestCoordinate(before), largestCoordinate(after));
    const VertexGrid grid(after, tolerance);
    std::vector<int> counterpart(static_cast<std::size_t>(before.vertexCount()), -1);
    for (int v = 0; v < before.vertexCount(); ++v) {
        const int weld = before.vertexWeld[v];
        counterpart[v] = weld == v ? grid.nearest(before.positions.row(v)) : counterpart[weld];
    }
    matchByVertices(before, after, counterpart, after.vertexWeld, Several::InOrder, match);
    if (std::ranges::find(match.face, -1) == match.face.end())
        return;
    // Where vertices of the new mesh are closer to each other than the tolerance, the nearest may be another
    // one.
    const std::vector<int> first = grid.firstOfEqual();
    for (int &vertex : counterpart)
        vertex = vertex < 0 ? vertex : first[vertex];
    matchByVertices(before, after, counterpart, first, Several::None, match);
}

} // namespace

FaceMatch FaceMatch::none(const MeshData &before)
{
    FaceMatch match;
    match.face.assign(static_cast<std::size_t>(before.faceCount()), -1);
    match.corner.assign(static_cast<std::size_t>(before.cornerCount()), -1);
    return match;
}

int FaceMatch::count() const
{
    return static_cast<int>(std::ranges::count_if(face, [](int other) { return other >= 0; }));
}

FaceMatch matchFacesInPlace(const MeshData &before, const MeshData &after, double tolerance)
{
    FaceMatch match = FaceMatch::none(before);
    matchByPosition(before, after, tolerance, match);
    return match;
}

FaceMatch matchFaces(const MeshData &before, const MeshData &after, double tolerance)
{
    const bool same = before.vertexCount() == after.vertexCount() && before.faceStart == after.faceStart &&
                      before.cornerVertex == after.cornerVertex;
    if (!same)
        return matchFacesInPlace(before, after, tolerance);
    FaceMatch match;
    match.sameTopology = true;
    match.face.resize(static_cast<std::size_t>(before.faceCount()));
    match.corner.resize(static_cast<std::size_t>(before.cornerCount()));
    std::iota(match.face.begin(), match.face.end(), 0);
    std::iota(match.corner.begin(), match.corner.end(), 0);
    return match;
}

FaceMatch matchFacesByNumbers(const MeshData &before, const MeshData &after)
{
    FaceMatch match = FaceMatch::none(before);
    if (before.vertexCount() != after.vertexCount())
        return match;
    std::vector<int> same(static_cast<std::size_t>(after.vertexCount()));
    std::iota(same.begin(), same.end(), 0);
    matchByVertices(before, after, same, same, Several::InOrder, match);
    return match;
}

} // namespace autocuts
