#include "solver/definite/seamsewing.h"

#include "model/plain/unionfind.h"
#include "model/plain/uvlayout.h"
#include "solver/base/cornerat.h"
#include "solver/energy/distortion.h"
#include "solver/homotopy/localsolve.h"
#include "solver/overlap/overlapfinder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace autocuts::definite {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Least area of each triangle after its corners were brought together, as a share of its area before, and
//! after a relaxation, as a share of its area at rest. The first as in chartjoining, the second as in
//! localsolve.
constexpr double smallestShare = 0.05;
constexpr double smallestSewnDeterminant = 1e-4;
//! Rings of faces around the seam that are relaxed; more when fewer do not do.
constexpr int rings[] = {4, 12, 40};
//! The two sides fit when closing the seam raises the distortion by no more than this share.
constexpr double fitTolerance = 1e-3;
//! A place other than that of the side that stays must be better by this share.
constexpr double gain = 1e-6;

//! UV vertices, by their first corners, and their places.
using Targets = std::vector<std::pair<int, Vec2>>;

//! Tries the ways of closing the seams of one map and keeps the best that is valid.
class Sewer
{
public:
    Sewer(const Soup &soup, const UvTopology &topology, const UvMatrix &before, const Sewing &sewing,
          const UvMatrix &placed)
        : mSoup(soup), mMesh(*soup.mesh), mTopology(topology), mBefore(before), mSewing(sewing),
          mPlaced(placed)
    {
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (role(mMesh.triangleFace[t]) != FaceRole::Outside)
                mTriangles.push_back(t);
        }
        findScale();
        mPlacedX = coordinates(placed);
        mEnergy = energy::symmetricDirichlet(mSoup, mPlacedX);
        mDistortion = total(mEnergy);
        findGroups();
    }

    SewOutcome sew(UvMatrix &uv, const JobContext &job)
    {
        const auto atSide = targets(false), inTheMiddle = targets(true);
        if (!atSide || !inTheMiddle)
            return SewOutcome::Held;
        tryOut(applied(*atSide, mPlaced), false);
        if (has(FaceRole::Yields))
            tryOut(applied(*inTheMiddle, mPlaced), false);
        const bool relaxes = !mBest || (isZip() && mBestDistortion > (1 + fitTolerance) * mDistortion);
        if (relaxes && !mSewing.asTheyFit)
            relaxAll(*atSide, *inTheMiddle, job);
        if (job.stopped())
            return SewOutcome::Stopped;
        if (!mBest)
            return mCovers ? SewOutcome::Covers : SewOutcome::Folds;
        uv = std::move(*mBest);
        return SewOutcome::Sewn;
    }

private:
    FaceRole role(int face) const { return mSewing.role[face]; }
    bool has(FaceRole wanted) const
    {
        return std::find(mSewing.role.begin(), mSewing.role.end(), wanted) != mSewing.role.end();
    }
    //! True when the seam is inside one island.
    bool isZip() const { return !has(FaceRole::Held) && !has(FaceRole::Yields); }
    double doubleArea(const UvMatrix &uv, int triangle) const
    {
        const auto &c = mMesh.triangles[triangle];
        return cross2(uv.row(c[0]).transpose(), uv.row(c[1]).transpose(), uv.row(c[2]).transpose());
    }

    //! Texture space to solver units in which the islands have their true size and are not mirrored.
    void findScale()
    {
        double sum = 0, uvArea = 0, weight = 0;
        for (const int t : mTriangles) {
            sum += doubleArea(mPlaced, t);
            uvArea += 0.5 * std::abs(doubleArea(mPlaced, t));
            weight += mSoup.weight[t];
        }
        mScale = uvArea > 0 ? std::sqrt(std::numbers::pi * weight / uvArea) : 1;
        mSide = sum < 0 ? -1 : 1;
    }

    std::vector<double> coordinates(const UvMatrix &uv) const
    {
        std::vector<double> x(mSoup.coordinateCount(), 0);
        for (const int t : mTriangles) {
            for (int k = 0; k < 3; ++k) {
                const auto row = uv.row(mMesh.triangles[t][k]);
                cornerAt(x, 3 * t + k) = mScale * Vec2(mSide * row.x(), row.y());
            }
        }
        return x;
    }
    //! Of the triangles that were not flipped at first.
    double total(const std::vector<double> &energy) const
    {
        double sum = 0;
        for (const int t : mTriangles) {
            if (std::isfinite(mEnergy[t]))
                sum += mSoup.weight[t] * energy[t];
        }
        return sum;
    }

    //! The UV vertices that become one.
    void findGroups()
    {
        UnionFind merged(mMesh.cornerCount());
        std::vector<int> roots;
        for (const int e : mSewing.edges) {
            for (const auto &[first, second] : mMesh.edgePairs[e].corner) {
                const int a = mTopology.cornerRoot[mMesh.cornerOfSoup(first)];
                const int b = mTopology.cornerRoot[mMesh.cornerOfSoup(second)];
                merged.unite(a, b);
                roots.insert(roots.end(), {a, b});
            }
        }
        std::sort(roots.begin(), roots.end());
        roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
        mGroupOf.assign(mMesh.cornerCount(), -1);
        for (const int root : roots) {
            mGroupOf[root] = merged.find(root);
            mGroups[mGroupOf[root]].push_back(root);
        }
        mPinned.assign(mMesh.cornerCount(), false);
        mFaceOfCorner.resize(mMesh.cornerCount());
        for (int f = 0; f < mMesh.faceCount(); ++f) {
            for (int c = mMesh.faceStart[f]; c < mMesh.faceStart[f + 1]; ++c) {
                mFaceOfCorner[c] = f;
                if (mSewing.pinned[c])
                    mPinned[mTopology.cornerRoot[c]] = true;
            }
        }
    }

    //! The places of all UV vertices at the seam. Nothing when two of one group are held in different places.
    std::optional<Targets> targets(bool inTheMiddle) const
    {
        Targets result;
        for (const auto &[group, members] : mGroups) {
            Vec2 sum = Vec2::Zero(), staying = Vec2::Zero();
            int yields = 0;
            std::optional<Vec2> held;
            for (const int root : members) {
                const Vec2 place = mPlaced.row(root).transpose();
                const FaceRole own = role(mFaceOfCorner[root]);
                if (own == FaceRole::Held || mPinned[root]) {
                    if (held && *held != place)
                        return std::nullopt;
                    held = place;
                }
                if (own == FaceRole::Yields) {
                    staying += place;
                    ++yields;
                }
                sum += place;
            }
            const Vec2 target = held                         ? *held
                                : yields > 0 && !inTheMiddle ? Vec2(staying / yields)
                                                             : Vec2(sum / double(members.size()));
            for (const int root : members)
                result.emplace_back(root, target);
        }
        return result;
    }

    //! The map with all corners of the UV vertices at their places.
    UvMatrix applied(const Targets &targets, UvMatrix uv) const
    {
        const std::map<int, Vec2> places(targets.begin(), targets.end());
        for (int c = 0; c < mMesh.cornerCount(); ++c) {
            if (mGroupOf[mTopology.cornerRoot[c]] >= 0)
                uv.row(c) = places.at(mTopology.cornerRoot[c]).transpose();
        }
        return uv;
    }

    //! Keeps the map when it is valid and better than the best so far.
    void tryOut(UvMatrix uv, bool relaxed)
    {
        const std::vector<double> x = coordinates(uv);
        const std::vector<double> energy = energy::symmetricDirichlet(mSoup, x);
        for (const int t : mTriangles) {
            if (!std::isfinite(mEnergy[t]))
                continue; // flipped before
            const double least = relaxed ? smallestSewnDeterminant
                                         : smallestShare * jacobianDeterminant(mSoup, mPlacedX.data(), t);
            if (!(jacobianDeterminant(mSoup, x.data(), t) > least) || !std::isfinite(energy[t]))
                return;
        }
        const double distortion = total(energy);
        if (mBest && !(distortion < (1 - gain) * mBestDistortion))
            return;
        if (mSewing.asTheyFit && !(distortion <= (1 + fitTolerance) * mDistortion))
            return;
        if (covers(uv)) {
            mCovers = true;
            return;
        }
        mBest = std::move(uv);
        mBestDistortion = distortion;
    }

    //! True when triangles overlap that did not overlap inside their islands before.
    bool covers(const UvMatrix &uv) const
    {
        overlap::OverlapOptions options;
        options.minAreaRatio = overlap::visibleOverlap;
        const auto pairsOf = [&](const UvMatrix &map) {
            return overlap::findOverlapsAmong(soupUv(mMesh, map), mTriangles, options).pairs;
        };
        const std::vector<overlap::OverlapPair> after = pairsOf(uv);
        if (after.empty())
            return false;
        const std::vector<overlap::OverlapPair> before = pairsOf(mBefore);
        const auto isLess = [](const overlap::OverlapPair &a, const overlap::OverlapPair &b) {
            return std::pair(a.first, a.second) < std::pair(b.first, b.second);
        };
        const auto chart = [&](int t) { return mTopology.charts.faceChart[mMesh.triangleFace[t]]; };
        const auto isNew = [&](const overlap::OverlapPair &pair) {
            return chart(pair.first) != chart(pair.second) ||
                   !std::binary_search(before.begin(), before.end(), pair, isLess);
        };
        return std::any_of(after.begin(), after.end(), isNew);
    }

    //! Relaxes more and more around the seam until the map is valid.
    void relaxAll(const Targets &atSide, const Targets &inTheMiddle, const JobContext &job)
    {
        for (const int count : rings) {
            relax(atSide, region(count, false), isZip(), job);
            if (!mBest && has(FaceRole::Yields))
                relax(inTheMiddle, region(count, true), true, job);
            if (mBest || job.stopped())
                return;
        }
    }

    //! The faces around the seam that may move, per face.
    std::vector<bool> region(int count, bool withYielding) const
    {
        std::vector<bool> near(mMesh.cornerCount(), false), in(mMesh.faceCount(), false);
        for (const auto &[group, members] : mGroups) {
            for (const int root : members)
                near[root] = true;
        }
        for (int ring = 0; ring < count; ++ring) {
            std::vector<int> added;
            for (int f = 0; f < mMesh.faceCount(); ++f) {
                if (in[f] || !(role(f) == FaceRole::Moves || (withYielding && role(f) == FaceRole::Yields)))
                    continue;
                for (int c = mMesh.faceStart[f]; c < mMesh.faceStart[f + 1] && !in[f]; ++c)
                    in[f] = near[mTopology.cornerRoot[c]];
                if (in[f])
                    added.push_back(f);
            }
            for (const int f : added) {
                for (int c = mMesh.faceStart[f]; c < mMesh.faceStart[f + 1]; ++c)
                    near[mTopology.cornerRoot[c]] = true;
            }
        }
        return in;
    }

    homotopy::LocalProblem problemIn(const std::vector<bool> &region, const std::vector<int> &points) const
    {
        homotopy::LocalProblem problem;
        problem.pointOfCorner = points;
        for (int f = 0; f < mMesh.faceCount(); ++f) {
            if (region[f])
                problem.faces.push_back(f);
            if (role(f) != FaceRole::Outside)
                problem.reference.push_back(f);
            for (int c = mMesh.faceStart[f]; c < mMesh.faceStart[f + 1]; ++c) {
                if (!region[f] || mPinned[mTopology.cornerRoot[c]])
                    problem.held.push_back(points[c]);
            }
        }
        return problem;
    }

    //! \param seamMoves the closed seam itself is relaxed, too
    void relax(const Targets &targets, const std::vector<bool> &region, bool seamMoves, const JobContext &job)
    {
        homotopy::LocalProblem problem = problemIn(region, mTopology.cornerRoot);
        problem.targets = targets;
        const homotopy::LocalSolution solution = homotopy::solveLocally(mMesh, mPlaced, problem, job);
        if (solution.outcome != homotopy::LocalSolution::Outcome::Solved)
            return;
        const UvMatrix closed = applied(targets, solution.uv);
        tryOut(closed, true);
        if (!seamMoves || job.stopped())
            return;
        std::vector<int> points = mTopology.cornerRoot;
        for (int &point : points)
            point = mGroupOf[point] >= 0 ? mGroupOf[point] : point;
        const homotopy::LocalSolution free =
            homotopy::solveLocally(mMesh, closed, problemIn(region, points), job);
        if (free.outcome == homotopy::LocalSolution::Outcome::Solved)
            tryOut(free.uv, true);
    }

    const Soup &mSoup;
    const MeshData &mMesh;
    const UvTopology &mTopology;
    const UvMatrix &mBefore;
    const Sewing &mSewing;
    const UvMatrix &mPlaced;
    std::vector<int> mTriangles; //!< of the islands at the seam
    double mScale = 1, mSide = 1;
    std::vector<double> mPlacedX,
        mEnergy; //!< coordinates, and energy per triangle, before the seam is closed
    double mDistortion = 0;
    std::map<int, std::vector<int>> mGroups; //!< UV vertices that become one, ascending, by the first
    std::vector<int> mGroupOf;               //!< per UV vertex, -1 away from the seam
    std::vector<int> mFaceOfCorner;
    std::vector<bool> mPinned; //!< per UV vertex
    std::optional<UvMatrix> mBest;
    double mBestDistortion = 0;
    bool mCovers = false;
};

} // namespace

SewOutcome sewSeams(const Soup &soup, const UvTopology &topology, const UvMatrix &before,
                    const Sewing &sewing, UvMatrix &uv, const JobContext &job)
{
    return Sewer(soup, topology, before, sewing, uv).sew(uv, job);
}

} // namespace autocuts::definite
