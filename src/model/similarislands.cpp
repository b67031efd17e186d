#include "model/similarislands.h"

#include "model/islands.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! Rounds of refinement; colours then tell neighbourhoods of this radius apart.
constexpr int refinementRounds = 8;
constexpr double lengthTolerance = 1e-4;

std::uint64_t mixed(std::uint64_t value)
{
    value += 0x9E3779B97F4A7C15ull;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ull;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBull;
    return value ^ (value >> 31);
}

//! Colours of the faces of an island, sorted: equal for islands with the same neighbourhoods.
std::vector<std::uint64_t> topologyColours(const MeshData &mesh, const MeshAdjacency &adjacency,
                                           const Islands &islands, int island,
                                           std::vector<std::uint64_t> &scratch)
{
    const std::vector<int> &faces = islands.faces(island);
    for (int face : faces)
        scratch[face] = mixed(mesh.faceStart[face + 1] - mesh.faceStart[face]);
    std::vector<std::uint64_t> next(faces.size());
    std::vector<std::uint64_t> around;
    for (int round = 0; round < refinementRounds; ++round) {
        for (std::size_t i = 0; i < faces.size(); ++i) {
            around.clear();
            for (int c = mesh.faceStart[faces[i]]; c < mesh.faceStart[faces[i] + 1]; ++c) {
                const auto &sides = adjacency.edgeFaces(adjacency.edgeOfCorner(c));
                const int other = sides[0] == faces[i] ? sides[1] : sides[0];
                const bool inside = other >= 0 && islands.islandOfFace(other) == island;
                around.push_back(inside ? scratch[other] : 0);
            }
            std::sort(around.begin(), around.end());
            next[i] = scratch[faces[i]];
            for (std::uint64_t colour : around)
                next[i] = mixed(next[i] ^ colour);
        }
        for (std::size_t i = 0; i < faces.size(); ++i)
            scratch[faces[i]] = next[i];
    }
    std::sort(next.begin(), next.end());
    return next;
}

std::vector<double> sideLengths(const MeshData &mesh, const MeshAdjacency &adjacency,
                                const std::vector<int> &faces)
{
    std::vector<double> lengths;
    for (int face : faces) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            lengths.push_back(adjacency.edgeLength(adjacency.edgeOfCorner(c)));
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

bool sameLengths(const std::vector<double> &a, const std::vector<double> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double x, double y) {
        return std::abs(x - y) <= lengthTolerance * std::max(a.back(), b.back());
    });
}

} // namespace

std::vector<int> similarIslands(const MeshData &mesh, const MeshAdjacency &adjacency, const Islands &islands,
                                int island, Similarity similarity)
{
    std::vector<std::uint64_t> scratch(mesh.faceCount(), 0);
    const auto colours = topologyColours(mesh, adjacency, islands, island, scratch);
    const auto lengths = sideLengths(mesh, adjacency, islands.faces(island));
    std::vector<int> result;
    for (int other = 0; other < islands.count(); ++other) {
        if (islands.faces(other).size() != islands.faces(island).size())
            continue;
        if (topologyColours(mesh, adjacency, islands, other, scratch) != colours)
            continue;
        if (similarity == Similarity::Shape &&
            !sameLengths(sideLengths(mesh, adjacency, islands.faces(other)), lengths))
            continue;
        result.push_back(other);
    }
    return result;
}

} // namespace autocuts
