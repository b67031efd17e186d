#include "support/steerings.h"

#include "model/plain/chart.h"
#include "model/plain/flippedtriangles.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/base/cutmesh.h"
#include "solver/base/random.h"
#include "solver/overlap/overlapfinder.h"

#include <cstring>
#include <map>
#include <set>

namespace autocuts::test {

namespace {

//! The island of a face of the map, and its faces.
std::vector<int> someIsland(const ChartMap &charts, Random &random)
{
    const auto faces = charts.faces();
    return faces[random.below(charts.count)];
}

//! Some faces around one.
std::vector<bool> someRegion(const MeshData &mesh, Random &random)
{
    std::vector<bool> region(mesh.faceCount(), false);
    region[random.below(mesh.faceCount())] = true;
    const int rings = 1 + random.below(4);
    for (int i = 0; i < rings; ++i) {
        const std::vector<bool> before = region;
        for (const EdgePair &pair : mesh.edgePairs) {
            const int a = mesh.triangleFace[pair.triangle[0]], b = mesh.triangleFace[pair.triangle[1]];
            if (before[a] || before[b])
                region[a] = region[b] = true;
        }
    }
    return region;
}

Eigen::AlignedBox2d boxOf(const MeshData &mesh, const UvMatrix &uv, const std::vector<int> &faces)
{
    Eigen::AlignedBox2d box;
    for (const int face : faces) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            box.extend(Vec2(uv.row(c)));
    }
    return box;
}

//! Adds one kind of steering after the other to a snapshot.
class Steerer
{
public:
    Steerer(const std::shared_ptr<const MeshData> &mesh, const UvMatrix &uv, unsigned seed)
        : mRandom(seed), mMesh(*mesh), mUv(uv), mCharts(findCharts(*mesh, uv)),
          mSteering(mSnapshot.editSteering())
    {
        mSnapshot.mesh = mesh;
        mSnapshot.settings.seed = seed;
    }

    Snapshot steered()
    {
        if (often())
            moveToTile();
        mSnapshot.uvScale = layoutScale(mMesh, mUv);
        if (often())
            decideEdges();
        if (often())
            paint();
        if (often())
            addPins();
        if (often())
            addRectangle();
        if (often())
            flagIslands();
        if (often())
            setScope();
        mSnapshot.uv = std::make_shared<const UvMatrix>(mUv);
        return mSnapshot;
    }

private:
    bool often() { return mRandom.uniform() < 0.4; }

    void moveToTile()
    {
        mSnapshot.keepTiles = true;
        for (const int face : someIsland(mCharts, mRandom)) {
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
                mUv(c, 0) += 1;
        }
    }

    void decideEdges()
    {
        mSteering.pairState.assign(mMesh.cornerPairCount(), PairState::Free);
        const int cuts = mRandom.below(6), joins = mRandom.below(4);
        for (int i = 0; i < cuts + joins; ++i) {
            const int e = mRandom.below(static_cast<int>(mMesh.edgePairs.size()));
            const PairState state = i < cuts ? PairState::Cut : PairState::Joined;
            if (!mMesh.edgePairs[e].diagonal)
                mSteering.pairState[2 * e] = mSteering.pairState[2 * e + 1] = state;
        }
    }

    void paint()
    {
        const std::vector<bool> region = someRegion(mMesh, mRandom);
        const double weight = mRandom.uniform() < 0.5 ? 0.1 : 10;
        mSteering.pairWeight.assign(mMesh.cornerPairCount(), 1);
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            if (region[mMesh.triangleFace[mMesh.edgePairs[e].triangle[0]]])
                mSteering.pairWeight[2 * e] = mSteering.pairWeight[2 * e + 1] = weight;
        }
    }

    void addPins()
    {
        const int count = 1 + mRandom.below(4);
        std::set<int> corners;
        for (int i = 0; i < count; ++i)
            corners.insert(mRandom.below(mMesh.cornerCount()));
        const bool hard = mRandom.uniform() < 0.7;
        for (const int corner : corners) {
            const Vec2 at =
                Vec2(mUv.row(corner)) + 0.05 * Vec2(mRandom.uniform(-1, 1), mRandom.uniform(-1, 1));
            for (int s = 0; s < mMesh.soupCornerCount(); ++s) {
                if (mMesh.cornerOfSoup(s) == corner)
                    mSteering.pins.push_back({s, at / mSnapshot.uvScale, hard, 1});
            }
        }
    }

    void addRectangle()
    {
        const std::vector<int> island = someIsland(mCharts, mRandom);
        const Vec2 size = mRandom.uniform(0.7, 2) * boxOf(mMesh, mUv, island).sizes();
        const Vec2 lower(mRandom.uniform(-2, 1), mRandom.uniform(-3, -2));
        UvRectangle box;
        box.lower = lower / mSnapshot.uvScale;
        box.upper = (lower + size) / mSnapshot.uvScale;
        box.hard = mRandom.uniform() < 0.5;
        for (const int face : island) {
            for (const int s : mMesh.soupCornersOf(face))
                box.soupCorners.push_back(s);
        }
        mSteering.rectangles.push_back(std::move(box));
    }

    void flagIslands()
    {
        mSteering.faceFlags.resize(mMesh.faceCount());
        const int kind = mRandom.below(3);
        for (int i = 0; i < 2; ++i) {
            for (const int face : someIsland(mCharts, mRandom)) {
                IslandFlags &flags = mSteering.faceFlags[face];
                if (kind == 0)
                    flags.locked = 1;
                else
                    (kind == 1 ? flags.stack : flags.group) = 1;
            }
        }
    }

    void setScope()
    {
        JobScope scope{someRegion(mMesh, mRandom), mRandom.uniform() < 0.5};
        if (mRandom.uniform() < 0.5) {
            scope.faces.assign(mMesh.faceCount(), false);
            for (const int face : someIsland(mCharts, mRandom))
                scope.faces[face] = true;
        }
        mSnapshot.scope = std::make_shared<const JobScope>(std::move(scope));
    }

    Random mRandom;
    const MeshData &mMesh;
    UvMatrix mUv;
    ChartMap mCharts;
    Snapshot mSnapshot;
    Steering &mSteering;
};

//! Checks the clauses one after the other.
class Checker
{
public:
    Checker(const Snapshot &before, const Outcome &after)
        : mBefore(before), mAfter(after), mMesh(*before.mesh), mSteering(*before.steering),
          mOld(findCharts(mMesh, *before.uv)), mNew(findCharts(mMesh, after.uv))
    {}

    QStringList check()
    {
        if (mAfter.uv.rows() != mMesh.cornerCount() || !mAfter.uv.allFinite())
            return {QStringLiteral("there is no map")};
        checkStill();
        checkValid();
        checkPins();
        checkEdges();
        checkRectangles();
        checkRigid();
        checkTiles();
        return mBroken;
    }

private:
    void say(const QString &text)
    {
        if (!mBroken.contains(text))
            mBroken << text;
    }

    bool sameRow(int c) const
    {
        return std::memcmp(Vec2(mAfter.uv.row(c)).data(), Vec2(mBefore.uv->row(c)).data(), sizeof(Vec2)) == 0;
    }

    IslandFlags flagsOfFace(int face) const
    {
        return mSteering.faceFlags.empty() ? IslandFlags{}
                                           : flagsOf(mSteering.faceFlags, mOld.faces()[mOld.faceChart[face]]);
    }

    bool mayChange(int face) const { return !mBefore.scope || mBefore.scope->faces[face]; }

    void checkStill()
    {
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const bool locked = flagsOfFace(face).locked != 0;
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                if (locked && !sameRow(c))
                    say(QStringLiteral("a locked island changed"));
                if (!mayChange(face) && !sameRow(c) && mAfter.reshapes)
                    say(QStringLiteral("a face outside the scope changed"));
            }
        }
    }

    void checkValid()
    {
        const std::vector<bool> flipped = flippedTriangles(mMesh, soupUv(mMesh, mAfter.uv), mNew.faceChart);
        if (std::find(flipped.begin(), flipped.end(), true) != flipped.end())
            say(QStringLiteral("a triangle is flipped"));
        if (mAfter.saysItFailed)
            return;
        overlap::OverlapOptions options;
        options.minAreaRatio = 1e-9;
        int pairs = 0;
        const UvMatrix soup = soupUv(mMesh, mAfter.uv);
        overlap::visitOverlaps(soup, options, [&](int a, int b, double) {
            const int f = mMesh.triangleFace[a], g = mMesh.triangleFace[b];
            const IslandFlags p = flagsOfFace(f), q = flagsOfFace(g);
            const bool stacked = p.stack != 0 && p.stack == q.stack;
            const bool pinned = isPinned(f) && isPinned(g); // the user's own places
            pairs += !stacked && !(pinned && mNew.faceChart[f] != mNew.faceChart[g]);
            return true;
        });
        if (pairs > 0)
            say(QStringLiteral("overlaps"));
    }

    //! True when something else than rectangles and packing decides where the island of a face is.
    bool isPinned(int face) const
    {
        for (const Pin &pin : mSteering.pins) {
            if (mNew.faceChart[mMesh.triangleFace[pin.soupCorner / 3]] == mNew.faceChart[face])
                return true;
        }
        for (int other = 0; other < mMesh.faceCount(); ++other) {
            if (mNew.faceChart[other] == mNew.faceChart[face] && !mayChange(other))
                return true;
        }
        return flagsOfFace(face).locked != 0;
    }

    //! False for faces whose islands are not for the job.
    bool isFree(int face) const { return mayChange(face) && flagsOfFace(face) == IslandFlags{}; }

    void checkPins()
    {
        for (const Pin &pin : mSteering.pins) {
            if (!pin.hard || !isFree(mMesh.triangleFace[pin.soupCorner / 3]) || !mAfter.reshapes)
                continue;
            if (mBefore.scope && mBefore.scope->attached)
                continue; // the border of the scope comes first
            const Vec2 at = mAfter.uv.row(mMesh.cornerOfSoup(pin.soupCorner));
            const std::vector<int> &unmet = mAfter.unmet.pins;
            const bool named =
                std::find(unmet.begin(), unmet.end(), mMesh.cornerOfSoup(pin.soupCorner)) != unmet.end();
            if (!named && (at - mBefore.uvScale * pin.target).norm() > 1e-6)
                say(QStringLiteral("a hard pin is missed by %1")
                        .arg((at - mBefore.uvScale * pin.target).norm(), 0, 'g', 2));
        }
    }

    //! True when the user's cuts alone part the corners at an end of the edge. A single cut does not.
    bool isOpenable(std::size_t edge) const
    {
        std::vector<bool> cut(mMesh.edgePairs.size());
        for (std::size_t e = 0; e < cut.size(); ++e)
            cut[e] = mSteering.pairState[2 * e] == PairState::Cut;
        const CutMesh state(mMesh, cut);
        const EdgePair &pair = mMesh.edgePairs[edge];
        return state.uvVertex[pair.corner[0][0]] != state.uvVertex[pair.corner[0][1]] ||
               state.uvVertex[pair.corner[1][0]] != state.uvVertex[pair.corner[1][1]];
    }

    void checkEdges()
    {
        if (mSteering.pairState.empty() || !mAfter.reshapes)
            return;
        const std::vector<bool> open = openCornerPairs(mMesh, mAfter.uv);
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const auto [a, b] = mMesh.edgePairs[e].triangle;
            if (!isFree(mMesh.triangleFace[a]) || !isFree(mMesh.triangleFace[b]))
                continue;
            if (mSteering.pairState[2 * e] == PairState::Cut && isOpenable(e) && !mAfter.cut.empty() &&
                !mAfter.cut[e])
                say(QStringLiteral("a cut is not a seam"));
            if (mBefore.isJoined(e) && (open[2 * e] || open[2 * e + 1]) && mAfter.unmet.joins.empty())
                say(QStringLiteral("a joined edge is open"));
        }
    }

    void checkRectangles()
    {
        if (!mAfter.reshapes && mAfter.uv == *mBefore.uv)
            return; // there was nothing to do
        for (const UvRectangle &box : mSteering.rectangles) {
            std::set<int> islands;
            for (const int corner : box.soupCorners) {
                const int face = mMesh.triangleFace[corner / 3];
                if (isFree(face) && !isPinned(face))
                    islands.insert(mNew.faceChart[face]);
            }
            const Eigen::AlignedBox2d place(Vec2(mBefore.uvScale * box.lower),
                                            Vec2(mBefore.uvScale * box.upper));
            for (int face = 0; face < mMesh.faceCount() && !mAfter.saysItFailed; ++face) {
                if (!islands.count(mNew.faceChart[face]))
                    continue;
                for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                    if (place.exteriorDistance(Vec2(mAfter.uv.row(c))) > 1e-6)
                        say(QStringLiteral("an island leaves its rectangle"));
                }
            }
        }
    }

    //! Islands of a stack or group: all distances grow alike.
    void checkRigid()
    {
        std::map<int, std::vector<int>> corners;
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const IslandFlags flags = flagsOfFace(face);
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                if (flags.locked == 0 && flags.stack + flags.group != 0)
                    corners[2 * flags.stack + 100 * flags.group].push_back(c);
            }
        }
        for (const auto &[piece, all] : corners) {
            const int first = all.front();
            int far = first;
            const auto length = [&](const UvMatrix &uv, int a, int b) {
                return (uv.row(a) - uv.row(b)).norm();
            };
            for (const int c : all)
                far = length(*mBefore.uv, first, c) > length(*mBefore.uv, first, far) ? c : far;
            const double scale = length(mAfter.uv, first, far) / length(*mBefore.uv, first, far);
            for (const int c : all) {
                for (const int from : {first, far}) {
                    if (std::abs(length(mAfter.uv, from, c) - scale * length(*mBefore.uv, from, c)) > 1e-9)
                        say(QStringLiteral("a stack or group is not rigid"));
                }
            }
        }
    }

    void checkTiles()
    {
        if (!mBefore.keepTiles || mAfter.saysItFailed || !mSteering.rectangles.empty())
            return;
        const std::vector<int> old = udimTiles(mMesh, *mBefore.uv, mBefore.tileHeight);
        const std::vector<int> now = udimTiles(mMesh, mAfter.uv, mBefore.tileHeight);
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const bool joined = std::find(mSteering.pairState.begin(), mSteering.pairState.end(),
                                          PairState::Joined) != mSteering.pairState.end();
            if (!isPinned(face) && !joined && mSteering.pins.empty() && old[face] != 0 &&
                now[face] != old[face])
                say(QStringLiteral("an island left its tile"));
        }
    }

    const Snapshot &mBefore;
    const Outcome &mAfter;
    const MeshData &mMesh;
    const Steering &mSteering;
    const ChartMap mOld, mNew;
    QStringList mBroken;
};

} // namespace

Snapshot steered(const std::shared_ptr<const MeshData> &mesh, const UvMatrix &uv, unsigned seed)
{
    return Steerer(mesh, uv, seed).steered();
}

QStringList broken(const Snapshot &before, const Outcome &after)
{
    return Checker(before, after).check();
}

} // namespace autocuts::test
