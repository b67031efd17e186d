#include "solver/rigid/unrolling.h"

#include "solver/base/cornerat.h"
#include "solver/rigid/flattening.h"
#include "solver/rigid/planemotion.h"

#include <algorithm>
#include <functional>
#include <numbers>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace autocuts::rigid {

namespace {

//! Mean energy above that of an isometry from which a region counts as stretched; a triangle counts with at
//! most the second number, as thin ones can be in any shape.
constexpr double mostStretch = 5e-4, mostOfThin = 1;
//! The same for slightly curved regions: 1 % of stretch and squeeze, about.
constexpr double mostOfCurved = 1e-3;
constexpr int sweepsOfThin = 8; // to turn thin triangles back; chosen by hand

class Unroller
{
public:
    Unroller(const Soup &soup, const RigidRegions &regions, const std::vector<double> &weight)
        : mSoup(soup), mMesh(*soup.mesh), mRegions(regions), mWeight(weight),
          mPlaced(mMesh.triangleCount(), false), mEdgeOf(mMesh.soupCornerCount(), -1)
    {
        mResult.x.assign(soup.coordinateCount(), 0);
        mResult.cut.assign(mMesh.edgePairs.size(), false);
        mResult.works.assign(regions.count, true);
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const EdgePair &pair = mMesh.edgePairs[e];
            for (int which = 0; which < 2; ++which)
                mEdgeOf[3 * pair.triangle[which] + pair.side(which)] = static_cast<int>(e);
        }
    }

    Unrolled run()
    {
        std::vector<int> largest(mRegions.count, -1);
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const int r = mRegions.region[t];
            if (r >= 0 && (largest[r] < 0 || mMesh.triangleArea[t] > mMesh.triangleArea[largest[r]]))
                largest[r] = t;
        }
        for (const int t : largest) {
            if (t >= 0)
                layOut(t);
        }
        cutOpenEdges();
        weld();
        flattenCurved();
        findFlippedRegions();
        findTornRegions();
        findStretchedRegions();
        return std::move(mResult);
    }

private:
    bool isCurved(int region) const { return mRegions.curved[region]; }

    int other(int e, int t) const
    {
        const EdgePair &pair = mMesh.edgePairs[e];
        return pair.triangle[0] == t ? pair.triangle[1] : pair.triangle[0];
    }

    //! Puts a triangle beside another one that is placed already.
    void place(int t, int e)
    {
        const EdgePair &pair = mMesh.edgePairs[e];
        const int own = pair.triangle[0] == t ? 0 : 1;
        const auto rest = [&](int corner) { return Vec2(cornerAt(mSoup.restShape[corner / 3], corner % 3)); };
        const PlaneMotion motion = PlaneMotion::between(rest(pair.corner[0][own]), rest(pair.corner[1][own]),
                                                        cornerAt(mResult.x, pair.corner[0][1 - own]),
                                                        cornerAt(mResult.x, pair.corner[1][1 - own]));
        for (int k = 0; k < 3; ++k)
            cornerAt(mResult.x, 3 * t + k) = motion(rest(3 * t + k));
    }

    //! In waves from the first triangle, so that the two ends of a ring meet along a short line; the
    //! triangles of one polygon together.
    void layOut(int first)
    {
        // Not in a polygon begun, less the weight, distance, edge, from which triangle.
        using Entry = std::tuple<bool, double, double, int, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        const auto reach = [&](int t, double distance) {
            mPlaced[t] = true;
            for (int side = 3 * t; side < 3 * t + 3; ++side) {
                const int e = mEdgeOf[side];
                const int next = e < 0 ? -1 : other(e, t);
                if (e >= 0 && !mPlaced[next] && mRegions.region[next] == mRegions.region[t])
                    queue.emplace(!mMesh.edgePairs[e].diagonal, mWeight.empty() ? -1 : -mWeight[e],
                                  distance + (centre(next) - centre(t)).norm(), e, t);
            }
        };
        for (int k = 0; k < 3; ++k)
            cornerAt(mResult.x, 3 * first + k) = cornerAt(mSoup.restShape[first], k);
        reach(first, 0);
        while (!queue.empty()) {
            const auto [leavesPolygon, cheapness, distance, edge, from] = queue.top();
            queue.pop();
            const int t = other(edge, from);
            if (mPlaced[t])
                continue;
            place(t, edge);
            reach(t, distance);
        }
    }

    Vec3 centre(int t) const
    {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < 3; ++k)
            sum += mMesh.cornerPosition(mMesh.cornerOfSoup(3 * t + k));
        return sum / 3;
    }

    void cutOpenEdges()
    {
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const EdgePair &pair = mMesh.edgePairs[e];
            const int a = mRegions.region[pair.triangle[0]], b = mRegions.region[pair.triangle[1]];
            if (a != b) {
                mResult.cut[e] = !pair.diagonal;
                continue;
            }
            if (a < 0 || isCurved(a))
                continue;
            const double limit = togetherShare * mSoup.pairLength[2 * e];
            for (int end = 0; end < 2; ++end) {
                const Vec2 gap =
                    cornerAt(mResult.x, pair.corner[end][0]) - cornerAt(mResult.x, pair.corner[end][1]);
                if (gap.norm() <= limit)
                    continue;
                mResult.cut[e] = true;
                if (pair.diagonal)
                    mResult.works[a] = false;
            }
        }
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e)
            mResult.cut[e] = mResult.cut[e] && !mMesh.edgePairs[e].diagonal;
        dropClosedCuts(mMesh, mResult.cut);
    }

    //! Gives the corners of each UV vertex their mean.
    void weld()
    {
        const CutMesh state(mMesh, mResult.cut);
        rigid::weld(state, mResult.x);
        for (int sweep = 0; sweep < sweepsOfThin; ++sweep) {
            for (int t = 0; t < mMesh.triangleCount(); ++t) {
                if (mRegions.region[t] >= 0 && !(jacobianDeterminant(mSoup, mResult.x.data(), t) > 0))
                    openThin(t, state);
            }
        }
    }

    void flattenCurved()
    {
        std::vector<std::vector<int>> curved(mRegions.count);
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (mRegions.region[t] >= 0 && isCurved(mRegions.region[t]))
                curved[mRegions.region[t]].push_back(t);
        }
        const CutMesh state(mMesh, mResult.cut);
        for (const std::vector<int> &triangles : curved) {
            if (!triangles.empty())
                flatten(mSoup, state, triangles, mResult.x);
        }
    }

    void findFlippedRegions()
    {
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (mRegions.region[t] >= 0 && !(jacobianDeterminant(mSoup, mResult.x.data(), t) > 0))
                mResult.works[mRegions.region[t]] = false;
        }
    }

    //! What does not unroll tears: cuts end inside the region, at more points than the tip of a cone.
    void findTornRegions()
    {
        const CutMesh uncut(mMesh, CutFlags(mMesh.edgePairs.size(), false));
        std::vector<int> cuts(uncut.uvVertexCount, 0), inside(uncut.uvVertexCount, -1);
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const EdgePair &pair = mMesh.edgePairs[e];
            const int a = mRegions.region[pair.triangle[0]], b = mRegions.region[pair.triangle[1]];
            for (int end = 0; end < 2 && mResult.cut[e]; ++end) {
                const int v = uncut.uvVertex[pair.corner[end][0]];
                ++cuts[v];
                inside[v] = a == b ? a : -1;
            }
        }
        for (const BoundarySide &open : mMesh.boundarySides) {
            for (int k = 0; k < 2; ++k)
                cuts[uncut.uvVertex[3 * open.triangle + (open.side + k) % 3]] += 2;
        }
        std::vector<int> ends(mRegions.count, 0);
        for (std::size_t v = 0; v < cuts.size(); ++v) {
            if (cuts[v] == 1 && inside[v] >= 0 && ++ends[inside[v]] > 1)
                mResult.works[inside[v]] = false;
        }
    }

    void findStretchedRegions()
    {
        mResult.excess.assign(mMesh.triangleCount(), 0);
        std::vector<double> excess(mRegions.count, 0), area(mRegions.count, 0);
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const int r = mRegions.region[t];
            if (r < 0 || !mResult.works[r] || mMesh.triangleDegenerate[t])
                continue;
            mResult.excess[t] = excessOf(mSoup, mResult.x, t);
            excess[r] += mSoup.weight[t] * std::min(mResult.excess[t], mostOfThin);
            area[r] += mSoup.weight[t];
        }
        for (int r = 0; r < mRegions.count; ++r) {
            if (excess[r] > (isCurved(r) ? mostOfCurved : mostStretch) * area[r])
                mResult.works[r] = false;
        }
    }

    //! A thin triangle that rounding has flipped: gives it its height again, by moving the corner opposite to
    //! its longest side.
    void openThin(int t, const CutMesh &state)
    {
        int top = 0;
        double longest = -1;
        for (int k = 0; k < 3; ++k) {
            const double side =
                (cornerAt(mResult.x, 3 * t + (k + 2) % 3) - cornerAt(mResult.x, 3 * t + (k + 1) % 3)).norm();
            if (side > longest) {
                longest = side;
                top = k;
            }
        }
        if (!(longest > 0))
            return;
        const Vec2 a = cornerAt(mResult.x, 3 * t + (top + 1) % 3),
                   b = cornerAt(mResult.x, 3 * t + (top + 2) % 3);
        const Vec2 apex = cornerAt(mResult.x, 3 * t + top);
        const Vec2 up = Vec2(-(b - a).y(), (b - a).x()) / longest;
        const double height = 2 * std::numbers::pi * mSoup.areaShare(t) / longest;
        const Vec2 moved = apex + (height - up.dot(apex - a)) * up;
        for (const int c : cornersAt(state, state.uvVertex[3 * t + top]))
            cornerAt(mResult.x, c) = moved;
    }

    const std::vector<int> &cornersAt(const CutMesh &state, int point)
    {
        if (mCornersOf.empty()) {
            mCornersOf.resize(state.uvVertexCount);
            for (int c = 0; c < mMesh.soupCornerCount(); ++c)
                mCornersOf[state.uvVertex[c]].push_back(c);
        }
        return mCornersOf[point];
    }

    const Soup &mSoup;
    const MeshData &mMesh;
    const RigidRegions &mRegions;
    const std::vector<double> &mWeight;       //!< per edge pair; may be empty
    std::vector<std::vector<int>> mCornersOf; //!< per UV vertex; empty until a thin triangle needs it
    std::vector<bool> mPlaced;                //!< per triangle
    std::vector<int> mEdgeOf;                 //!< per triangle side: its edge pair, -1 at a border
    Unrolled mResult;
};

} // namespace

void weld(const CutMesh &state, std::vector<double> &x)
{
    std::vector<Vec2> sum(state.uvVertexCount, Vec2::Zero());
    std::vector<int> count(state.uvVertexCount, 0);
    const int corners = static_cast<int>(state.uvVertex.size());
    for (int c = 0; c < corners; ++c) {
        sum[state.uvVertex[c]] += cornerAt(x, c);
        ++count[state.uvVertex[c]];
    }
    for (int c = 0; c < corners; ++c)
        cornerAt(x, c) = sum[state.uvVertex[c]] / count[state.uvVertex[c]];
}

double excessOf(const Soup &soup, const std::vector<double> &x, int t)
{
    const double *p = &x[6 * static_cast<std::size_t>(t)];
    const Soup::Basis &b = soup.basis[t];
    double squares = 0;
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column) {
            const double entry = p[row] * b[column] + p[2 + row] * b[2 + column] + p[4 + row] * b[4 + column];
            squares += entry * entry;
        }
    }
    const double det = jacobianDeterminant(soup, x.data(), t);
    return squares + squares / (det * det) - 4;
}

Unrolled unroll(const Soup &soup, const RigidRegions &regions, const std::vector<double> &weight)
{
    return Unroller(soup, regions, weight).run();
}

} // namespace autocuts::rigid
