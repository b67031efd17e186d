#include "solver/rigid/nets.h"

#include "model/plain/unionfind.h"
#include "solver/base/constant.h"
#include "solver/base/cornerat.h"
#include "solver/base/random.h"
#include "solver/overlap/overlapfinder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace autocuts::rigid {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Overlaps that count, as shares of the whole area: anywhere, and (of the smaller triangle) between
//! triangles that meet in a point of the model, where the two sides of a hinge differ by rounding.
constexpr double overlapShare = 1e-10, touchingShare = 1e-5;
//! The latter beside curved regions, whose borders do not quite fit.
AUTOCUTS_CONSTANT(double, gapShare, 0.2);
//! Energy of a triangle above that of an isometry, where its region is laid in the plane, from which it does
//! not keep its shape.
AUTOCUTS_CONSTANT(double, mostExcess, 0.1);
//! Mean energy of a chart above that of an isometry up to which it joins nets. Chosen by hand: .02 and .3
//! make little difference.
AUTOCUTS_CONSTANT(double, nearlyIsometric, 0.1);
constexpr double noise = 0.5; // of the costs, natural logarithm

//! Which side of an edge belongs to the first region of a hinge.
int firstSide(const MeshData &mesh, const RigidRegions &regions, const Hinge &hinge, int edge)
{
    return regions.region[mesh.edgePairs[edge].triangle[0]] == hinge.first ? 0 : 1;
}

//! Grows nets by joining them in pairs.
class NetGrower
{
public:
    //! \param net per triangle: the net that it is in at first, -1: none \param x the nets in the plane
    NetGrower(const Soup &soup, const RigidRegions &regions, std::vector<int> net, std::vector<double> x)
        : mSoup(soup), mRegions(regions), mX(std::move(x)), mNet(std::move(net)),
          mTriangles(mNet.empty() ? 0 : *std::max_element(mNet.begin(), mNet.end()) + 1),
          mGroups(static_cast<int>(mTriangles.size())),
          mPoint(CutMesh(*soup.mesh, CutFlags(soup.mesh->edgePairs.size(), false)).uvVertex)
    {
        for (int t = 0; t < soup.triangleCount(); ++t) {
            if (mNet[t] >= 0)
                mTriangles[mNet[t]].push_back(t);
        }
    }

    //! Joins the nets at the two sides of a hinge unless the result would overlap itself.
    void join(const Hinge &hinge)
    {
        const EdgePair &longest = mSoup.mesh->edgePairs[hinge.edges.front()];
        const int side = firstSide(*mSoup.mesh, mRegions, hinge, hinge.edges.front());
        int fixed = side, a = netAt(longest, side), b = netAt(longest, 1 - side);
        if (a == b)
            return;
        if (mTriangles[a].size() < mTriangles[b].size()) {
            std::swap(a, b);
            fixed = 1 - fixed;
        }
        const auto end = [&](int which, int of) { return Vec2(cornerAt(mX, longest.corner[which][of])); };
        std::vector<Vec2> moved;
        const auto move = [&](const auto &motion) {
            for (const int t : mTriangles[b]) {
                for (int k = 0; k < 3; ++k)
                    moved.push_back(motion(cornerAt(mX, 3 * t + k)));
            }
        };
        if (hinge.gap > 0) {
            // The best motion takes the second region to the first one, or back.
            const RigidMotion best = motionOf(mX, *mSoup.mesh, mRegions, hinge);
            const PlaneMotion motion{best.c, best.s, best.shift};
            move(fixed == side ? motion : motion.inverse());
        } else {
            move(PlaneMotion::between(end(0, 1 - fixed), end(1, 1 - fixed), end(0, fixed), end(1, fixed)));
        }
        if (flips(moved) ||
            overlap(mTriangles[a], mTriangles[b], moved, hinge.gap > 0 ? gapShare : touchingShare))
            return;
        for (std::size_t i = 0; i < moved.size(); ++i)
            cornerAt(mX, 3 * mTriangles[b][i / 3] + static_cast<int>(i % 3)) = moved[i];
        mGroups.unite(a, b);
        const int root = mGroups.find(a), other = root == a ? b : a;
        mTriangles[root].insert(mTriangles[root].end(), mTriangles[other].begin(), mTriangles[other].end());
        mTriangles[other].clear();
    }

    //! Closes the edges of a hinge that lie together in one net, whether or not it was this hinge that
    //! brought them there.
    void close(const Hinge &hinge, CutFlags &cut)
    {
        for (const int e : hinge.edges) {
            const EdgePair &pair = mSoup.mesh->edgePairs[e];
            bool together = netAt(pair, 0) == netAt(pair, 1);
            for (int end = 0; end < 2; ++end) {
                const Vec2 gap = cornerAt(mX, pair.corner[end][0]) - cornerAt(mX, pair.corner[end][1]);
                together = together &&
                           gap.norm() <=
                               hinge.gap + togetherShare * mSoup.pairLength[2 * static_cast<std::size_t>(e)];
            }
            if (together)
                cut[e] = false;
        }
    }

    const std::vector<double> &coordinates() const { return mX; }

private:
    int netAt(const EdgePair &pair, int side) { return mGroups.find(mNet[pair.triangle[side]]); }

    //! True when rounding flips a thin triangle where it comes to lie.
    static bool flips(const std::vector<Vec2> &corners)
    {
        for (std::size_t c = 0; c < corners.size(); c += 3) {
            if (!(cross2(corners[c], corners[c + 1], corners[c + 2]) > 0))
                return true;
        }
        return false;
    }

    //! True when triangles of two nets overlap. \param moved the corners of the second net's triangles
    //! \param touching share of their area that triangles with a common point may have in common
    bool overlap(const std::vector<int> &fixed, const std::vector<int> &moving,
                 const std::vector<Vec2> &moved, double touching) const
    {
        Vec2 low = moved.front(), high = low;
        for (const Vec2 &p : moved) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        std::vector<int> near;
        for (const int t : fixed) {
            const Vec2 a = cornerAt(mX, 3 * t), b = cornerAt(mX, 3 * t + 1), c = cornerAt(mX, 3 * t + 2);
            if ((a.cwiseMin(b).cwiseMin(c).array() <= high.array()).all() &&
                (a.cwiseMax(b).cwiseMax(c).array() >= low.array()).all())
                near.push_back(t);
        }
        const int first = static_cast<int>(near.size());
        UvMatrix uv(3 * near.size() + moved.size(), 2);
        for (std::size_t i = 0; i < near.size(); ++i) {
            for (int k = 0; k < 3; ++k)
                uv.row(3 * i + k) = cornerAt(mX, 3 * near[i] + k).transpose();
        }
        for (std::size_t i = 0; i < moved.size(); ++i)
            uv.row(3 * near.size() + i) = moved[i].transpose();
        overlap::OverlapOptions options;
        options.totalArea = std::numbers::pi;
        options.minAreaRatio = overlapShare;
        return !overlap::visitOverlaps(uv, options, [&](int i, int j, double area) {
            if (i >= first || j < first)
                return true;
            const int a = near[i], b = moving[j - first];
            return meet(a, b) &&
                   area <= touching * std::numbers::pi * std::min(mSoup.areaShare(a), mSoup.areaShare(b));
        });
    }

    bool meet(int a, int b) const
    {
        for (int k = 0; k < 3; ++k) {
            for (int l = 0; l < 3; ++l) {
                if (mPoint[3 * a + k] == mPoint[3 * b + l])
                    return true;
            }
        }
        return false;
    }

    const Soup &mSoup;
    const RigidRegions &mRegions;
    std::vector<double> mX;
    std::vector<int> mNet;                    //!< per triangle: the net that it was in at first, -1: none
    std::vector<std::vector<int>> mTriangles; //!< per net
    UnionFind mGroups;                        //!< of the first nets
    std::vector<int> mPoint;                  //!< per soup corner: vertex of the uncut surface
};

std::vector<int> dearestFirst(const std::vector<double> &cost)
{
    std::vector<int> order(cost.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return cost[a] > cost[b]; });
    return order;
}

std::vector<double> edgeWeights(const Snapshot &snapshot)
{
    std::vector<double> weights;
    for (std::size_t e = 0; e < snapshot.mesh->edgePairs.size(); ++e)
        weights.push_back(snapshot.edgeWeight(e));
    return weights;
}

} // namespace

Nets::Nets(std::shared_ptr<const Soup> soup, const Snapshot &snapshot)
    : mSoup(std::move(soup)), mRegions(snapshot.rigid),
      mUnrolled(unroll(*mSoup, *mRegions, edgeWeights(snapshot))), mAlwaysCut(mRegions->apart)
{
    const std::vector<PairState> &states = snapshot.steering->pairState;
    mAlwaysCut.resize(mSoup->mesh->edgePairs.size(), false);
    for (std::size_t p = 0; p < states.size(); ++p) {
        if (states[p] == PairState::Cut)
            mAlwaysCut[p / 2] = true;
    }
    const std::vector<bool> overlap = overlapThemselves();
    for (int r = 0; r < mRegions->count; ++r)
        mUnrolled.works[r] = mUnrolled.works[r] && !overlap[r];
    findHinges(snapshot);
}

void Nets::findHinges(const Snapshot &snapshot)
{
    mHinges = rigid::findHinges(*mSoup, *mRegions, mUnrolled, mAlwaysCut);
    mCost.clear();
    for (const Hinge &hinge : mHinges) {
        double cost = 0;
        for (const int e : hinge.edges)
            cost += snapshot.edgeWeight(e) * mSoup->pairLength[2 * static_cast<std::size_t>(e)];
        mCost.push_back(cost);
    }
}

std::vector<bool> Nets::overlapThemselves() const
{
    std::vector<int> region;
    std::vector<Vec2> corners;
    for (int t = 0; t < mSoup->triangleCount(); ++t) {
        const int r = mRegions->region[t];
        if (r < 0 || !mUnrolled.works[r])
            continue;
        region.push_back(r);
        for (int k = 0; k < 3; ++k)
            corners.push_back(cornerAt(mUnrolled.x, 3 * t + k));
    }
    UvMatrix uv(corners.size(), 2);
    for (std::size_t c = 0; c < corners.size(); ++c)
        uv.row(c) = corners[c].transpose();
    overlap::OverlapOptions options;
    options.totalArea = std::numbers::pi;
    options.minAreaRatio = overlapShare;
    std::vector<bool> overlap(mRegions->count, false);
    overlap::visitOverlapsWithin(uv, region, options, [&](int a, int, double) {
        overlap[region[a]] = true;
        return true;
    });
    return overlap;
}

Nets Nets::withCharts(const SeamedMap &map, const Snapshot &snapshot) const
{
    const MeshData &mesh = *mSoup->mesh;
    Nets nets = *this;
    RigidRegions regions = *mRegions;
    const CutMesh state(mesh, map.cut);
    std::vector<int> regionOf(state.chartCount, -1);
    std::vector<double> excess(mRegions->count, 0), area(mRegions->count, 0); // per region
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (mRegions->region[t] >= 0)
            continue;
        int &r = regionOf[state.chart[t]];
        if (r < 0) {
            r = regions.count++;
            excess.push_back(0);
            area.push_back(0);
        }
        regions.region[t] = r;
        excess[r] += mSoup->weight[t] * excessOf(*mSoup, map.x, t);
        area[r] += mSoup->weight[t];
        for (int c = 3 * t; c < 3 * t + 3; ++c)
            cornerAt(nets.mUnrolled.x, c) = cornerAt(map.x, c);
    }
    regions.curved.resize(regions.count, false);
    for (int r = mRegions->count; r < regions.count; ++r)
        nets.mUnrolled.works.push_back(excess[r] <= nearlyIsometric * area[r]);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto [a, b] = mesh.edgePairs[e].triangle;
        if (mRegions->region[a] < 0 && mRegions->region[b] < 0)
            nets.mUnrolled.cut[e] = map.cut[e];
    }
    nets.mRegions = std::make_shared<const RigidRegions>(std::move(regions));
    nets.findHinges(snapshot);
    return nets;
}

SeamedMap Nets::joined(int number, SeamedMap map, const JobContext &job) const
{
    Random random(static_cast<std::uint64_t>(number) + 1);
    std::vector<double> worth = mCost;
    for (double &cost : worth)
        cost *= number > 0 ? std::exp(noise * random.uniform(-1, 1)) : 1;
    const std::vector<int> order = dearestFirst(worth);
    NetGrower nets(*mSoup, *mRegions, mRegions->region, mUnrolled.x);
    for (const int h : order) {
        if (job.stopped())
            return map;
        nets.join(mHinges[h]);
    }
    const MeshData &mesh = *mSoup->mesh;
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        if (const int r = mRegions->region[c / 3]; r >= 0 && mUnrolled.works[r])
            cornerAt(map.x, c) = cornerAt(nets.coordinates(), c);
    }
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const int r = mRegions->region[mesh.edgePairs[e].triangle[0]];
        if (r >= 0 && r == mRegions->region[mesh.edgePairs[e].triangle[1]] && mUnrolled.works[r])
            map.cut[e] = mUnrolled.cut[e] || mAlwaysCut[e];
    }
    for (const Hinge &hinge : mHinges)
        nets.close(hinge, map.cut);
    dropClosedCuts(mesh, map.cut);
    weld(CutMesh(mesh, map.cut), map.x);
    return map;
}

std::vector<bool> Nets::keepsShape() const
{
    std::vector<bool> keeps(mSoup->triangleCount());
    for (int t = 0; t < mSoup->triangleCount(); ++t) {
        const int r = mRegions->region[t];
        keeps[t] = r >= 0 && !mRegions->curved[r] && mUnrolled.works[r] && mUnrolled.excess[t] < mostExcess;
    }
    return keeps;
}

SeamedMap Nets::cutOut(const std::vector<bool> &which, SeamedMap map, bool joining,
                       const JobContext &job) const
{
    const MeshData &mesh = *mSoup->mesh;
    const auto regionOf = [&](int t) {
        const int r = mRegions->region[t];
        return r >= 0 && which[r] && mUnrolled.works[r] ? r : -1;
    };
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        if (regionOf(c / 3) >= 0)
            cornerAt(map.x, c) = cornerAt(mUnrolled.x, c);
    }
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const int a = regionOf(mesh.edgePairs[e].triangle[0]), b = regionOf(mesh.edgePairs[e].triangle[1]);
        if (a != b)
            map.cut[e] = true;
        else if (a >= 0)
            map.cut[e] = mUnrolled.cut[e] || mAlwaysCut[e];
    }
    if (joining) {
        NetGrower nets(*mSoup, *mRegions, CutMesh(mesh, map.cut).chart, std::move(map.x));
        for (const int h : dearestFirst(mCost)) {
            if (!job.stopped() && (which[mHinges[h].first] || which[mHinges[h].second]))
                nets.join(mHinges[h]);
        }
        for (const Hinge &hinge : mHinges) {
            if (which[hinge.first] || which[hinge.second])
                nets.close(hinge, map.cut);
        }
        map.x = nets.coordinates();
    }
    dropClosedCuts(mesh, map.cut);
    weld(CutMesh(mesh, map.cut), map.x);
    return map;
}

} // namespace autocuts::rigid
