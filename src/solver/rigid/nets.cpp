#include "solver/rigid/nets.h"

#include "model/plain/unionfind.h"
#include "solver/base/cornerat.h"
#include "solver/base/random.h"
#include "solver/overlap/overlapfinder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace autocuts::rigid {

namespace {

//! Overlaps that count, as shares of the whole area: anywhere, and (of the smaller triangle) between
//! triangles that meet in a point of the model, where the two sides of a hinge differ by rounding.
constexpr double overlapShare = 1e-10, touchingShare = 1e-5;
constexpr double noise = 0.5; // of the costs, natural logarithm; chosen by hand

//! Grows nets by joining them in pairs.
class NetGrower
{
public:
    NetGrower(const Soup &soup, const RigidRegions &regions, const Unrolled &unrolled)
        : mSoup(soup), mX(unrolled.x), mGroups(regions.count), mMotion(regions.count),
          mTriangles(regions.count)
    {
        for (int t = 0; t < soup.triangleCount(); ++t) {
            if (const int r = regions.region[t]; r >= 0)
                mTriangles[r].push_back(t);
        }
        mMembers.resize(regions.count);
        for (int r = 0; r < regions.count; ++r)
            mMembers[r] = {r};
        const CutMesh uncut(*soup.mesh, CutFlags(soup.mesh->edgePairs.size(), false));
        mPoint = uncut.uvVertex;
    }

    //! Joins the nets of the two regions of a hinge unless the result would overlap itself.
    void join(const Hinge &hinge)
    {
        int a = mGroups.find(hinge.first), b = mGroups.find(hinge.second);
        if (a == b)
            return;
        // Takes the frame of the second net to that of the first.
        PlaneMotion motion = mMotion[hinge.first].after(hinge.motion).after(mMotion[hinge.second].inverse());
        if (mTriangles[a].size() < mTriangles[b].size()) {
            std::swap(a, b);
            motion = motion.inverse();
        }
        std::vector<Vec2> moved;
        for (const int t : mTriangles[b]) {
            for (int k = 0; k < 3; ++k)
                moved.push_back(motion(cornerAt(mX, 3 * t + k)));
        }
        if (overlap(mTriangles[a], mTriangles[b], moved))
            return;
        for (std::size_t i = 0; i < moved.size(); ++i)
            cornerAt(mX, 3 * mTriangles[b][i / 3] + static_cast<int>(i % 3)) = moved[i];
        for (const int r : mMembers[b])
            mMotion[r] = motion.after(mMotion[r]);
        mGroups.unite(a, b);
        const int root = mGroups.find(a), other = root == a ? b : a;
        mTriangles[root].insert(mTriangles[root].end(), mTriangles[other].begin(), mTriangles[other].end());
        mMembers[root].insert(mMembers[root].end(), mMembers[other].begin(), mMembers[other].end());
        mTriangles[other].clear();
        mMembers[other].clear();
    }

    bool together(int a, int b) { return mGroups.find(a) == mGroups.find(b); }
    const std::vector<double> &coordinates() const { return mX; }

private:
    //! True when triangles of two nets overlap. \param moved the corners of the second net's triangles
    bool overlap(const std::vector<int> &fixed, const std::vector<int> &moving,
                 const std::vector<Vec2> &moved) const
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
            return meet(a, b) && area <= touchingShare * std::numbers::pi *
                                             std::min(mSoup.areaShare(a), mSoup.areaShare(b));
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
    std::vector<double> mX;
    UnionFind mGroups;                                  //!< of regions: nets
    std::vector<PlaneMotion> mMotion;                   //!< per region: from where it was unrolled to its net
    std::vector<std::vector<int>> mTriangles, mMembers; //!< per net: triangles, regions
    std::vector<int> mPoint;                            //!< per soup corner: vertex of the uncut surface
};

} // namespace

namespace {

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
    mHinges = findHinges(*mSoup, *mRegions, mUnrolled, mAlwaysCut);
    for (const Hinge &hinge : mHinges) {
        double cost = 0;
        for (const int e : hinge.edges)
            cost += snapshot.edgeWeight(e) * mSoup->pairLength[2 * static_cast<std::size_t>(e)];
        mCost.push_back(cost);
    }
}

SeamedMap Nets::joined(int number, SeamedMap map, const JobContext &job) const
{
    Random random(static_cast<std::uint64_t>(number) + 1);
    std::vector<double> worth = mCost;
    for (double &cost : worth)
        cost *= number > 0 ? std::exp(noise * random.uniform(-1, 1)) : 1;
    std::vector<int> order(worth.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return worth[a] > worth[b]; });
    NetGrower nets(*mSoup, *mRegions, mUnrolled);
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
    // Edges that came together, whether or not their hinge was the one that brought them there.
    for (const Hinge &hinge : mHinges) {
        if (!nets.together(hinge.first, hinge.second))
            continue;
        for (const int e : hinge.edges) {
            const EdgePair &pair = mesh.edgePairs[e];
            bool close = true;
            for (int end = 0; end < 2; ++end) {
                const Vec2 gap = cornerAt(map.x, pair.corner[end][0]) - cornerAt(map.x, pair.corner[end][1]);
                close =
                    close && gap.norm() <= togetherShare * mSoup->pairLength[2 * static_cast<std::size_t>(e)];
            }
            if (close)
                map.cut[e] = false;
        }
    }
    dropClosedCuts(mesh, map.cut);
    weld(CutMesh(mesh, map.cut), map.x);
    return map;
}

} // namespace autocuts::rigid
