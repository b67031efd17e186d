#include "solver/unwrap/keptplaces.h"

#include "model/plain/unionfind.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/unwrap/unmetsteering.h"

#include <algorithm>
#include <cmath>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! A tile is packed anew where the islands that do not fit into it save more than this share of the seams.
constexpr double worthPacking = 0.1;
//! Share of the border along the axes that may be lost.
constexpr double lostAlignment = 0.02;
constexpr double rounding = 1e-9;

bool isAny(const std::vector<bool> &flags)
{
    return std::ranges::find(flags, true) != flags.end();
}

//! Islands of the map before and charts of the new one, in *groups*: those that have faces in common, and
//! with symmetric seams their mirror images. A group is as before, or new.
class KeptPlaces final
{
public:
    KeptPlaces(const Snapshot &snapshot, const FreePart &part, const PackJob &pack, const NewCharts &made)
        : mSnapshot(snapshot), mMesh(*snapshot.mesh), mBefore(*snapshot.uv), mOld(findCharts(mMesh, mBefore)),
          mPack(pack), mMade(made)
    {
        UnionFind sets(mOld.count + made.charts.count);
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            if (mOld.faceChart[face] >= 0 && made.charts.faceChart[face] >= 0)
                sets.unite(mOld.faceChart[face], mOld.count + made.charts.faceChart[face]);
        }
        uniteMirrorImages(sets);
        const auto [label, count] = sets.labels();
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int chart = made.charts.faceChart[face];
            mGroup.push_back(chart >= 0 ? label[mOld.count + chart] : -1);
        }
        mMayReturn.assign(count, true);
        mReturned.assign(count, false);
        mPack.options.rotation = PackRotation::None;
        mPack.stays.resize(mMesh.faceCount());
        forbidInvalid();
        forbidDisobeying(part);
    }

    //! \returns false when there is no room, or islands that pins hold cover what would be as before
    bool run(NewCharts &map, const JobContext &job)
    {
        map = mMade;
        for (;;) {
            PackJob pack = mPack;
            for (int face = 0; face < mMesh.faceCount(); ++face)
                pack.stays[face] = pack.stays[face] || isReturned(face);
            const std::vector<bool> misplaced = misplacedFaces(mMesh, map.charts, pack, map.uv, job);
            if (job.stopped())
                return false;
            if (!isAny(misplaced) || packAround(mMesh, map.charts, pack, misplaced, map.uv, job))
                return !coversReturned(map.uv);
            if (!returnGroupsOf(misplaced))
                return false;
            mixMaps(map);
        }
    }

    //! The faces whose islands did not fit.
    std::vector<bool> returnedFaces() const
    {
        std::vector<bool> faces;
        for (int face = 0; face < mMesh.faceCount(); ++face)
            faces.push_back(isReturned(face));
        return faces;
    }

private:
    void uniteMirrorImages(UnionFind &sets) const
    {
        if (mSnapshot.settings.symmetry != SymmetryMode::On)
            return;
        const std::optional<preference::MeshSymmetry> symmetry = preference::findSymmetry(mMesh);
        // The island of an edge, -1 on a seam: which side is the image of which is not known there.
        const auto islandAt = [this](std::size_t edge) {
            const auto [a, b] = mMesh.edgePairs[edge].triangle;
            const int one = mOld.faceChart[mMesh.triangleFace[a]];
            return one == mOld.faceChart[mMesh.triangleFace[b]] ? one : -1;
        };
        for (std::size_t e = 0; symmetry && e < mMesh.edgePairs.size(); ++e) {
            const int image = symmetry->mirrorEdge[e];
            const int own = islandAt(e), other = image < 0 ? -1 : islandAt(image);
            if (own >= 0 && other >= 0)
                sets.unite(own, other);
        }
    }

    bool isReturned(int face) const { return mGroup[face] >= 0 && mReturned[mGroup[face]]; }

    void forbid(int face)
    {
        if (mGroup[face] >= 0)
            mMayReturn[mGroup[face]] = false;
    }

    //! What has no UVs, is flipped, covers something or is off its tile in the map before is not kept.
    void forbidInvalid()
    {
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const auto &[a, b, c] = mMesh.triangles[t];
            const double area = cross2(Vec2(mBefore.row(a)), Vec2(mBefore.row(b)), Vec2(mBefore.row(c)));
            if (!(area > 0) && (mMesh.triangleArea[t] > 0 || !std::isfinite(area)))
                forbid(mMesh.triangleFace[t]);
        }
        overlap::visitOverlaps(soupUv(mMesh, mBefore), {}, [&](int a, int b, double) {
            forbid(mMesh.triangleFace[a]);
            forbid(mMesh.triangleFace[b]);
            return true;
        });
        const std::vector<bool> away = misplacedFaces(mMesh, mOld, mPack, mBefore);
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            if (away[face])
                forbid(face);
        }
    }

    //! What is to be cut or joined is not as it was.
    void forbidDisobeying(const FreePart &part)
    {
        const std::vector<PairState> &states = part.snapshot().steering->pairState;
        if (states.empty())
            return;
        const std::vector<bool> open = openCornerPairs(mMesh, mBefore);
        for (std::size_t e = 0; e < states.size() / 2; ++e) {
            const int edge = part.wholeEdge(static_cast<int>(e));
            const std::array now{open[2 * edge], open[2 * edge + 1]};
            const auto is = [&](std::size_t end, PairState state) { return states[2 * e + end] == state; };
            const bool closedCut = !now[0] && !now[1] && (is(0, PairState::Cut) || is(1, PairState::Cut));
            const bool openJoin =
                (now[0] && is(0, PairState::Joined)) || (now[1] && is(1, PairState::Joined));
            if (closedCut || openJoin)
                forbid(mMesh.triangleFace[mMesh.edgePairs[edge].triangle[0]]);
        }
    }

    //! True when a new island covers one that is as before: it is held by pins, so that packing leaves it.
    bool coversReturned(const UvMatrix &uv) const
    {
        const auto stackOf = [this](int face) {
            return mPack.faceFlags.empty() ? 0 : mPack.faceFlags[face].stack;
        };
        return isAny(mReturned) && !overlap::visitOverlaps(soupUv(mMesh, uv), {}, [&](int a, int b, double) {
                   const int f = mMesh.triangleFace[a], g = mMesh.triangleFace[b];
                   return isReturned(f) == isReturned(g) || (stackOf(f) != 0 && stackOf(f) == stackOf(g));
               });
    }

    //! Lets the groups of some faces be as before. \returns false when none may
    bool returnGroupsOf(const std::vector<bool> &faces)
    {
        bool any = false;
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int group = mGroup[face];
            if (!faces[face] || group < 0 || mReturned[group] || !mMayReturn[group])
                continue;
            mReturned[group] = any = true;
        }
        return any;
    }

    //! Takes the groups that are as before from the map before, the others from the new one.
    void mixMaps(NewCharts &map) const
    {
        std::vector<int> oldNumber(mOld.count, -1);
        map = mMade;
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            if (!isReturned(face))
                continue;
            int &number = oldNumber[mOld.faceChart[face]];
            if (number < 0) {
                number = map.charts.count++;
                ++map.notReplaced;
            }
            map.charts.faceChart[face] = number;
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
                map.uv.row(c) = mBefore.row(c);
        }
    }

    const Snapshot &mSnapshot;
    const MeshData &mMesh;
    const UvMatrix &mBefore;
    const ChartMap mOld;
    PackJob mPack;
    const NewCharts &mMade;
    std::vector<int> mGroup;                 //!< per face; -1: none
    std::vector<bool> mMayReturn, mReturned; //!< per group
};

} // namespace

bool keepPlaces(const Snapshot &snapshot, const FreePart &part, const PackJob &pack, double maxDistortion,
                NewCharts &map, const JobContext &job)
{
    const MeshData &mesh = *snapshot.mesh;
    KeptPlaces places(snapshot, part, pack, map);
    NewCharts kept;
    if (!places.run(kept, job))
        return false;
    if (kept.notReplaced == 0) {
        map = std::move(kept);
        return true;
    }
    const auto measured = [&](const UvMatrix &uv) {
        return metrics::measureShapes(mesh, uv, snapshot.tileHeight);
    };
    const metrics::UvMetrics before = measured(*snapshot.uv), made = measured(map.uv),
                             mixed = measured(kept.uv);
    PackJob anew = pack;
    anew.options.keepScale = true;
    if (mixed.seamLength - made.seamLength > worthPacking * before.seamLength &&
        packTilesOf(mesh, map.charts, anew, places.returnedFaces(), map.uv, job))
        return true;
    if (mixed.tileDirichlet > std::max(maxDistortion, made.tileDirichlet) + rounding ||
        mixed.axisAlignedShare < made.axisAlignedShare - lostAlignment ||
        unmetSteering(snapshot, kept.uv).count() > unmetSteering(snapshot, map.uv).count())
        return false;
    map = std::move(kept);
    return true;
}

} // namespace autocuts::unwrap
