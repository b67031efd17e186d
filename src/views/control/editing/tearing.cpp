#include "views/control/editing/tearing.h"

#include "model/document/document.h"
#include "solver/overlap/maxflow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

//! A face comes off when all of its corners follow at least this far; that is half of the radius of a drag.
constexpr double nearHand = 0.5625;
//! Capacities of the cut: of the longest edge, and of one that never tears.
constexpr double longestEdge = 1e6, maxWeight = 1e6;
constexpr std::int64_t neverTears = 1'000'000'000'000'000;

//! Finds the cheapest seam between the faces near the hand and those that stay.
class Tearing
{
public:
    Tearing(const Document &document, const std::vector<float> &separation,
            const std::vector<double> &follows)
        : mDocument(document), mMesh(document.mesh()), mFollows(follows), mEdges(mMesh.faceCount()),
          mNode(mMesh.faceCount(), -1)
    {
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const EdgePair &pair = mMesh.edgePairs[e];
            mLongest = std::max(mLongest, pair.length);
            if (pair.diagonal || std::min(separation[2 * e], separation[2 * e + 1]) >= 0.5f)
                continue;
            for (const int triangle : pair.triangle)
                mEdges[mMesh.triangleFace[triangle]].push_back(static_cast<int>(e));
        }
    }

    std::optional<TornPart> find()
    {
        collect();
        if (!mSomeStay)
            return std::nullopt;
        overlap::MaxFlow flow(static_cast<int>(mFaces.size()));
        for (std::size_t node = 0; node < mFaces.size(); ++node) {
            if (comesOff(mFaces[node]))
                flow.setSource(static_cast<int>(node));
            else if (stays(mFaces[node]))
                flow.setSink(static_cast<int>(node));
        }
        const std::vector<int> edges = collectedEdges();
        for (const int e : edges) {
            const auto [a, b] = nodesAt(e);
            flow.addEdge(a, b, costOf(e));
        }
        if (flow.run() >= neverTears)
            return std::nullopt;
        return partOf(flow.sourceSide(), edges);
    }

private:
    //! Faces from the hand up to the first ones that stay.
    void collect()
    {
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            if (comesOff(face))
                add(face);
        }
        for (std::size_t head = 0; head < mFaces.size(); ++head) {
            const int face = mFaces[head];
            if (!comesOff(face) && stays(face)) {
                mSomeStay = true;
                continue;
            }
            for (const int e : mEdges[face]) {
                for (const int triangle : mMesh.edgePairs[e].triangle)
                    add(mMesh.triangleFace[triangle]);
            }
        }
    }

    void add(int face)
    {
        if (mNode[face] >= 0)
            return;
        mNode[face] = static_cast<int>(mFaces.size());
        mFaces.push_back(face);
    }

    bool comesOff(int face) const
    {
        bool inHand = false, allNear = true;
        for (const int s : mMesh.soupCornersOf(face)) {
            inHand = inHand || mFollows[s] == 1;
            allNear = allNear && mFollows[s] >= nearHand;
        }
        return inHand || allNear;
    }

    bool stays(int face) const
    {
        const auto corners = mMesh.soupCornersOf(face);
        return std::any_of(corners.begin(), corners.end(), [this](int s) { return mFollows[s] == 0; });
    }

    std::array<int, 2> nodesAt(int edge) const
    {
        const auto &triangle = mMesh.edgePairs[edge].triangle;
        return {mNode[mMesh.triangleFace[triangle[0]]], mNode[mMesh.triangleFace[triangle[1]]]};
    }

    //! Closed edges between collected faces, ascending.
    std::vector<int> collectedEdges() const
    {
        std::vector<int> edges;
        for (const int face : mFaces) {
            for (const int e : mEdges[face]) {
                const auto [a, b] = nodesAt(e);
                if (a >= 0 && b >= 0 && a != b)
                    edges.push_back(e);
            }
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        return edges;
    }

    //! By length, as painted.
    std::int64_t costOf(int edge) const
    {
        const Seams &seams = mDocument.seams();
        const std::size_t p = 2 * static_cast<std::size_t>(edge);
        if (seams.states[p] == PairState::Joined || seams.states[p + 1] == PairState::Joined)
            return neverTears;
        const double weight = std::min(0.5 * (seams.weights[p] + seams.weights[p + 1]), maxWeight);
        const double share = mLongest > 0 ? mMesh.edgePairs[edge].length / mLongest : 0;
        return 1 + std::llround(longestEdge * share * weight);
    }

    std::optional<TornPart> partOf(const std::vector<bool> &isOff, const std::vector<int> &edges) const
    {
        TornPart part;
        for (const int e : edges) {
            const auto [a, b] = nodesAt(e);
            if (isOff[a] != isOff[b])
                part.edges.push_back(e);
        }
        for (std::size_t node = 0; node < mFaces.size(); ++node) {
            if (!isOff[node])
                continue;
            const auto corners = mMesh.soupCornersOf(mFaces[node]);
            part.soupCorners.insert(part.soupCorners.end(), corners.begin(), corners.end());
        }
        std::sort(part.soupCorners.begin(), part.soupCorners.end());
        return part.edges.empty() ? std::nullopt : std::optional(std::move(part));
    }

    const Document &mDocument;
    const MeshData &mMesh;
    const std::vector<double> &mFollows;
    double mLongest = 0;
    std::vector<std::vector<int>> mEdges; //!< per face: edge pairs across which the island goes on
    std::vector<int> mNode;               //!< per face; -1: not collected
    std::vector<int> mFaces;              //!< per node
    bool mSomeStay = false;
};

} // namespace

std::optional<TornPart> tornPart(const Document &document, const std::vector<float> &separation,
                                 const std::vector<double> &follows)
{
    return Tearing(document, separation, follows).find();
}

double strainOf(const UvMatrix &before, const UvMatrix &now, const std::vector<int> &soupCorners)
{
    double most = 1;
    int last = -1;
    for (const int s : soupCorners) {
        const int first = s - s % 3;
        if (std::exchange(last, first) == first)
            continue;
        const auto sides = [first](const UvMatrix &uv) {
            Eigen::Matrix2d m;
            m << (uv.row(first + 1) - uv.row(first)).transpose(),
                (uv.row(first + 2) - uv.row(first)).transpose();
            return m;
        };
        const Eigen::Matrix2d rest = sides(before);
        if (!rest.allFinite() || rest.determinant() == 0)
            continue;
        const Eigen::Matrix2d change = sides(now) * rest.inverse();
        const double det = change.determinant();
        if (!(det > 0))
            return std::numeric_limits<double>::infinity();
        // The singular values have the sum of squares `sum` and the product `det`.
        const double sum = change.squaredNorm();
        const double larger = std::sqrt(0.5 * (sum + std::sqrt(std::max(sum * sum - 4 * det * det, 0.0))));
        most = std::max({most, larger, larger / det});
    }
    return most;
}

} // namespace autocuts
