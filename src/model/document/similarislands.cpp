#include "model/document/similarislands.h"

#include "model/document/islands.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts {

namespace {

//! Rounds of colour refinement: colours distinguish neighbourhoods of this many faces in radius. Chosen by
//! hand; its effect has not been measured.
constexpr int refinementRounds = 8;
//! Lengths that differ by less than this share of the longest one are equal. Chosen by hand.
constexpr double lengthTolerance = 1e-4;

std::uint64_t mixed(std::uint64_t value)
{
    value += 0x9E3779B97F4A7C15ull;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ull;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBull;
    return value ^ (value >> 31);
}

//! Colours of the faces of an island, equal for faces with the same neighbourhoods.
std::vector<std::uint64_t> faceColours(const MeshData &mesh, const MeshAdjacency &adjacency,
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
    return next;
}

//! The colours of an island's faces, sorted: equal for islands with the same neighbourhoods.
std::vector<std::uint64_t> topologyColours(const MeshData &mesh, const MeshAdjacency &adjacency,
                                           const Islands &islands, int island,
                                           std::vector<std::uint64_t> &scratch)
{
    std::vector<std::uint64_t> colours = faceColours(mesh, adjacency, islands, island, scratch);
    std::sort(colours.begin(), colours.end());
    return colours;
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

//! Maps one island onto another, face by face, beginning with a given pair of corners.
class IslandMatch
{
public:
    IslandMatch(const MeshData &mesh, const MeshAdjacency &adjacency, const Islands &islands, int from,
                int to)
        : mMesh(mesh), mAdjacency(adjacency), mIslands(islands), mFrom(from), mTo(to),
          mSource(mesh.cornerCount(), -1), mUsed(mesh.faceCount())
    {
        for (int face : islands.faces(from)) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                mTolerance = std::max(mTolerance, lengthTolerance * length(c, 1));
        }
    }

    //! Tries to map the islands from one pair of corners on.
    //! \param first corner of `to`
    //! \param source the corner of `from` that it is mapped to
    bool follow(int first, int source)
    {
        mSource.assign(mSource.size(), -1);
        mUsed.assign(mUsed.size(), false);
        mQueue.clear();
        if (!layFace(first, source))
            return false;
        for (std::size_t next = 0; next < mQueue.size(); ++next) {
            const int face = mQueue[next];
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                if (!cross(c))
                    return false;
            }
        }
        return mQueue.size() == mIslands.faces(mTo).size();
    }
    int source(int corner) const { return mSource[corner]; }

private:
    //! The corner `steps` places further in its polygon.
    int further(int corner, int steps) const
    {
        const int face = mAdjacency.faceOfCorner(corner), first = mMesh.faceStart[face];
        return first + (corner - first + steps) % (mMesh.faceStart[face + 1] - first);
    }
    double length(int corner, int steps) const
    {
        return (mMesh.cornerPosition(corner) - mMesh.cornerPosition(further(corner, steps))).norm();
    }
    bool sameLength(int a, int b, int steps) const
    {
        return std::abs(length(a, steps) - length(b, steps)) <= mTolerance;
    }

    bool layFace(int corner, int source)
    {
        const int face = mAdjacency.faceOfCorner(corner), onto = mAdjacency.faceOfCorner(source);
        const int count = mMesh.faceStart[face + 1] - mMesh.faceStart[face];
        if (mUsed[onto] || count != mMesh.faceStart[onto + 1] - mMesh.faceStart[onto])
            return false;
        for (int k = 0; k < count; ++k, corner = further(corner, 1), source = further(source, 1)) {
            // The second length distinguishes polygons with equal sides and different angles.
            if (!sameLength(corner, source, 1) || !sameLength(corner, source, 2))
                return false;
            mSource[corner] = source;
        }
        mUsed[onto] = true;
        mQueue.push_back(face);
        return true;
    }

    //! The corner at which the face on the other side of the edge starts that edge; -1 when the island has no
    //! face there.
    int across(int corner, int island) const
    {
        const int edge = mAdjacency.edgeOfCorner(corner), face = mAdjacency.faceOfCorner(corner);
        const auto &sides = mAdjacency.edgeFaces(edge);
        const int other = sides[0] == face ? sides[1] : sides[0];
        if (other < 0 || other == face || mIslands.islandOfFace(other) != island)
            return -1;
        for (int c = mMesh.faceStart[other]; c < mMesh.faceStart[other + 1]; ++c) {
            if (mAdjacency.edgeOfCorner(c) == edge)
                return c;
        }
        return -1;
    }

    bool cross(int corner)
    {
        const int next = across(corner, mTo), source = across(mSource[corner], mFrom);
        if (next < 0 || source < 0)
            return next < 0 && source < 0;
        return mSource[next] < 0 ? layFace(next, source) : mSource[next] == source;
    }

    const MeshData &mMesh;
    const MeshAdjacency &mAdjacency;
    const Islands &mIslands;
    const int mFrom, mTo;
    double mTolerance = 0;
    std::vector<int> mSource; //!< per corner
    std::vector<bool> mUsed;  //!< per face of `from`
    std::vector<int> mQueue;  //!< faces of `to` that have been mapped
};

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

std::vector<int> copiedCorners(const MeshData &mesh, const MeshAdjacency &adjacency, const Islands &islands,
                               int from, int to)
{
    std::vector<std::uint64_t> scratch(mesh.faceCount(), 0);
    const auto colours = faceColours(mesh, adjacency, islands, from, scratch);
    const auto others = faceColours(mesh, adjacency, islands, to, scratch);
    // Starting at the rarest colour leaves the fewest pairs to try.
    std::map<std::uint64_t, int> counts;
    for (std::uint64_t colour : colours)
        ++counts[colour];
    const auto rarest =
        std::min_element(colours.begin(), colours.end(),
                         [&](std::uint64_t a, std::uint64_t b) { return counts[a] < counts[b]; });
    const int seed = mesh.faceStart[islands.faces(from)[rarest - colours.begin()]];
    IslandMatch match(mesh, adjacency, islands, from, to);
    for (std::size_t i = 0; i < others.size(); ++i) {
        const int face = islands.faces(to)[i];
        for (int c = mesh.faceStart[face]; others[i] == *rarest && c < mesh.faceStart[face + 1]; ++c) {
            if (!match.follow(c, seed))
                continue;
            std::vector<int> result = islands.corners(mesh, {to});
            for (int &corner : result)
                corner = match.source(corner);
            return result;
        }
    }
    return {};
}

} // namespace autocuts
