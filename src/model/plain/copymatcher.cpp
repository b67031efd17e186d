#include "model/plain/copymatcher.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts {

namespace {

//! Rounds of colour refinement: colours distinguish neighbourhoods of this many faces in radius. Chosen by
//! hand; its effect has not been measured.
constexpr int refinementRounds = 8;
// Lengths that differ by less than this share of the longest one, or of themselves, are equal. Chosen by
// hand.
constexpr double exactTolerance = 1e-4, nearTolerance = 0.05;

bool sameLength(double a, double b, double longest, CopyLikeness likeness)
{
    return std::abs(a - b) <=
           (likeness == CopyLikeness::Exact ? exactTolerance * longest : nearTolerance * std::max(a, b));
}

std::uint64_t mixed(std::uint64_t value)
{
    value += 0x9E3779B97F4A7C15ull;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ull;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBull;
    return value ^ (value >> 31);
}

} // namespace

CopyMatcher::CopyMatcher(const MeshData &mesh, const MeshAdjacency &adjacency,
                         const std::vector<int> &groupOfFace, const std::vector<std::vector<int>> &faces)
    : mMesh(mesh), mAdjacency(adjacency), mGroupOfFace(groupOfFace), mFaces(faces),
      mColour(mesh.faceCount(), 0), mSource(mesh.cornerCount(), -1), mUsed(mesh.faceCount(), false)
{}

std::vector<std::uint64_t> CopyMatcher::colours(int group)
{
    const std::vector<int> &faces = mFaces[group];
    for (const int face : faces)
        mColour[face] = mixed(mMesh.faceStart[face + 1] - mMesh.faceStart[face]);
    std::vector<std::uint64_t> next(faces.size());
    std::vector<std::uint64_t> around;
    for (int round = 0; round < refinementRounds; ++round) {
        for (std::size_t i = 0; i < faces.size(); ++i) {
            around.clear();
            for (int c = mMesh.faceStart[faces[i]]; c < mMesh.faceStart[faces[i] + 1]; ++c) {
                const auto &sides = mAdjacency.edgeFaces(mAdjacency.edgeOfCorner(c));
                const int other = sides[0] == faces[i] ? sides[1] : sides[0];
                const bool inside = other >= 0 && mGroupOfFace[other] == group;
                around.push_back(inside ? mColour[other] : 0);
            }
            std::sort(around.begin(), around.end());
            next[i] = mColour[faces[i]];
            for (const std::uint64_t colour : around)
                next[i] = mixed(next[i] ^ colour);
        }
        for (std::size_t i = 0; i < faces.size(); ++i)
            mColour[faces[i]] = next[i];
    }
    return next;
}

std::vector<double> CopyMatcher::sideLengths(int group) const
{
    std::vector<double> lengths;
    for (const int face : mFaces[group]) {
        for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
            lengths.push_back(mAdjacency.edgeLength(mAdjacency.edgeOfCorner(c)));
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

bool CopyMatcher::sameLengths(const std::vector<double> &a, const std::vector<double> &b,
                              CopyLikeness likeness)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double x, double y) {
        return sameLength(x, y, std::max(a.back(), b.back()), likeness);
    });
}

bool CopyMatcher::match(int from, int to, bool mirrored, const std::vector<std::uint64_t> &fromColours,
                        const std::vector<std::uint64_t> &toColours, CopyLikeness likeness)
{
    mFrom = from;
    mTo = to;
    mStep = mirrored ? -1 : 1;
    mLikeness = likeness;
    mLongest = 0;
    for (const int face : mFaces[from]) {
        for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
            mLongest = std::max(mLongest, length(c, 1));
    }
    // Starting at the rarest colour leaves the fewest pairs to try.
    std::map<std::uint64_t, int> counts;
    for (const std::uint64_t colour : fromColours)
        ++counts[colour];
    const auto rarest =
        std::min_element(fromColours.begin(), fromColours.end(),
                         [&](std::uint64_t a, std::uint64_t b) { return counts[a] < counts[b]; });
    const int seed = mMesh.faceStart[mFaces[from][rarest - fromColours.begin()]];
    for (std::size_t i = 0; i < toColours.size(); ++i) {
        const int face = mFaces[to][i];
        for (int c = mMesh.faceStart[face]; toColours[i] == *rarest && c < mMesh.faceStart[face + 1]; ++c) {
            if (follow(c, seed))
                return true;
        }
    }
    return false;
}

int CopyMatcher::sourceSide(int corner) const
{
    return mStep > 0 ? mSource[corner] : mSource[further(corner, 1)];
}

//! Tries to match the groups from one pair of corners on.
//! \param first corner of `to` \param source the corner of `from` that it is matched with
bool CopyMatcher::follow(int first, int source)
{
    // Not more than the two groups: there may be very many.
    for (const int face : mFaces[mTo])
        std::fill(mSource.begin() + mMesh.faceStart[face], mSource.begin() + mMesh.faceStart[face + 1], -1);
    for (const int face : mFaces[mFrom])
        mUsed[face] = false;
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
    return mQueue.size() == mFaces[mTo].size();
}

//! The corner `steps` places further in its polygon.
int CopyMatcher::further(int corner, int steps) const
{
    const int face = mAdjacency.faceOfCorner(corner), first = mMesh.faceStart[face];
    const int count = mMesh.faceStart[face + 1] - first;
    return first + (corner - first + steps + count) % count;
}

double CopyMatcher::length(int corner, int steps) const
{
    return (mMesh.cornerPosition(corner) - mMesh.cornerPosition(further(corner, steps))).norm();
}

bool CopyMatcher::layFace(int corner, int source)
{
    const int face = mAdjacency.faceOfCorner(corner), onto = mAdjacency.faceOfCorner(source);
    const int count = mMesh.faceStart[face + 1] - mMesh.faceStart[face];
    if (mUsed[onto] || count != mMesh.faceStart[onto + 1] - mMesh.faceStart[onto])
        return false;
    for (int k = 0; k < count; ++k, corner = further(corner, 1), source = further(source, mStep)) {
        // The second length distinguishes polygons with equal sides and different angles.
        for (const int steps : {1, 2}) {
            if (!sameLength(length(corner, steps), length(source, mStep * steps), mLongest, mLikeness))
                return false;
        }
        mSource[corner] = source;
    }
    mUsed[onto] = true;
    mQueue.push_back(face);
    return true;
}

//! The corner at which the face on the other side of the edge starts that edge; -1 when the group has no face
//! there.
int CopyMatcher::across(int corner, int group) const
{
    const int edge = mAdjacency.edgeOfCorner(corner), face = mAdjacency.faceOfCorner(corner);
    const auto &sides = mAdjacency.edgeFaces(edge);
    const int other = sides[0] == face ? sides[1] : sides[0];
    if (other < 0 || other == face || mGroupOfFace[other] != group)
        return -1;
    for (int c = mMesh.faceStart[other]; c < mMesh.faceStart[other + 1]; ++c) {
        if (mAdjacency.edgeOfCorner(c) == edge)
            return c;
    }
    return -1;
}

bool CopyMatcher::cross(int corner)
{
    const int next = across(corner, mTo);
    int source = across(sourceSide(corner), mFrom);
    if (next < 0 || source < 0)
        return next < 0 && source < 0;
    if (mStep < 0)
        source = further(source, 1); // mirrored sides begin at the other end
    return mSource[next] < 0 ? layFace(next, source) : mSource[next] == source;
}

} // namespace autocuts
