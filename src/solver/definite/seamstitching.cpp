#include "solver/definite/seamstitching.h"

#include "model/plain/unionfind.h"
#include "model/plain/uvseams.h"
#include "solver/definite/seamfitting.h"
#include "solver/definite/seamopening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace autocuts::definite {

namespace {

//! Scales beyond this, or below its inverse, are no fit: the seam has no length on one of its sides.
constexpr double largestScale = 1e6;

//! An island of the present map.
struct Island
{
    double area = 0; //!< in the map, twice; negative when mirrored
    bool locked = false;
    bool pinned = false; //!< hard

    bool isHeld() const { return locked || pinned; }
};

//! Seams to close together: those between two islands, or a part of those inside an island.
struct Seam
{
    int first = 0, second = 0; //!< islands
    std::vector<int> edges;    //!< edge pairs
    double length = 0;         //!< in 3D

    void add(int edge, double edgeLength)
    {
        edges.push_back(edge);
        length += edgeLength;
    }
};

//! Stitches one seam after the other; each success makes the map from which the next one starts.
class SeamStitcher
{
public:
    SeamStitcher(const Snapshot &snapshot, const std::vector<int> &edges, const JobContext &job)
        : mSnapshot(snapshot), mMesh(*snapshot.mesh), mJob(job), mSoup(Soup::build(snapshot.mesh)),
          mPinned(mMesh.cornerCount(), false)
    {
        mResult.uv = *snapshot.uv;
        for (const Pin &pin : snapshot.steering->pins) {
            if (pin.hard)
                mPinned[mMesh.cornerOfSoup(pin.soupCorner)] = true;
        }
        for (const int e : edges) {
            if (e < static_cast<int>(mMesh.edgePairs.size()) && !mMesh.edgePairs[e].diagonal)
                mOpen.insert(e);
        }
    }

    StitchedMap stitch()
    {
        look();
        // First what fits as it is, so that nothing is bent to it that was bent to something else before.
        for (const bool asTheyFit : {true, false}) {
            mAsTheyFit = asTheyFit;
            mResult.refused.clear();
            dropClosed(!asTheyFit);
            std::set<int> left;
            while (!mOpen.empty() && !mJob.stopped())
                stitchNext(left);
            mOpen = std::move(left);
        }
        std::sort(mResult.edges.begin(), mResult.edges.end());
        return std::move(mResult);
    }

private:
    UvMatrix &uv() { return mResult.uv; }
    Vec2 place(int corner) const { return mResult.uv.row(corner).transpose(); }
    int islandOf(int triangle) const { return mTopology.charts.faceChart[mMesh.triangleFace[triangle]]; }

    //! \param left receives the edges that could not be closed
    void stitchNext(std::set<int> &left)
    {
        Seam seam = nextSeam();
        const SewOutcome outcome = mAsTheyFit ? closeFitting(seam) : closeMost(seam);
        for (const int e : seam.edges)
            mOpen.erase(e);
        if (outcome == SewOutcome::Sewn) {
            mResult.edges.insert(mResult.edges.end(), seam.edges.begin(), seam.edges.end());
            look();
            dropClosed(true);
        } else {
            left.insert(seam.edges.begin(), seam.edges.end());
            mResult.refused[outcome] += static_cast<int>(seam.edges.size());
        }
        const double done = static_cast<double>(mResult.edges.size());
        mJob.report(done / (done + static_cast<double>(mOpen.size() + left.size())));
    }

    //! Finds the islands and seams of the present map.
    void look()
    {
        mTopology = findUvTopology(mMesh, uv());
        mIsOpen = openCornerPairs(mMesh, uv());
        mIslands.assign(mTopology.charts.count, {});
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const auto &c = mMesh.triangles[t];
            if (islandOf(t) < 0)
                continue;
            Island &island = mIslands[islandOf(t)];
            island.area += cross2(place(c[0]), place(c[1]), place(c[2]));
            island.pinned = island.pinned || mPinned[c[0]] || mPinned[c[1]] || mPinned[c[2]];
        }
        mSeamsAt.assign(mMesh.vertexCount(), 0);
        for (int e = 0; e < static_cast<int>(mMesh.edgePairs.size()); ++e) {
            for (const auto &ends : mMesh.edgePairs[e].corner)
                mSeamsAt[mMesh.vertexOfSoup(ends[0])] += !mMesh.edgePairs[e].diagonal && isSeam(e);
        }
        const auto faces = mTopology.charts.faces();
        for (std::size_t i = 0; i < mIslands.size(); ++i)
            mIslands[i].locked = !mSnapshot.steering->faceFlags.empty() &&
                                 flagsOf(mSnapshot.steering->faceFlags, faces[i]).locked != 0;
    }

    bool isSeam(int edge) const
    {
        const auto [first, second] = mMesh.edgePairs[edge].triangle;
        return islandOf(first) >= 0 && islandOf(second) >= 0 && (mIsOpen[2 * edge] || mIsOpen[2 * edge + 1]);
    }

    //! Takes edges that are no seams off the list. \param stitched another seam has closed them
    void dropClosed(bool stitched)
    {
        for (auto e = mOpen.begin(); e != mOpen.end();) {
            if (isSeam(*e)) {
                ++e;
                continue;
            }
            if (stitched)
                mResult.edges.push_back(*e);
            e = mOpen.erase(e);
        }
    }

    //! Between islands first: those that fit exactly before the others, so that what was ripped closes again
    //! before anything else is closed, then the one at the largest island, then the longest. Then parts
    //! inside islands, those whose sides are nearest first. \pre there are open edges
    Seam nextSeam() const
    {
        std::map<std::pair<int, int>, Seam> seams;
        for (const int e : mOpen) {
            const auto [a, b] = std::minmax(
                {islandOf(mMesh.edgePairs[e].triangle[0]), islandOf(mMesh.edgePairs[e].triangle[1])});
            seams.try_emplace({a, b}, Seam{a, b, {}}).first->second.add(e, mMesh.edgePairs[e].length);
        }
        const auto order = [&](const Seam &seam) {
            const double first = std::abs(mIslands[seam.first].area);
            const double second = std::abs(mIslands[seam.second].area);
            const bool isZip = seam.first == seam.second;
            const bool exact =
                mAsTheyFit && !isZip && !exactEdges(matchesOf(movingOf(seam), seam.edges)).empty();
            return std::tuple(!isZip, exact, std::max(first, second), seam.length);
        };
        const Seam *best = nullptr;
        decltype(order(*best)) rank;
        for (const auto &[islands, seam] : seams) {
            if (const auto own = order(seam); !best || rank < own) {
                best = &seam;
                rank = own;
            }
        }
        if (best->first != best->second)
            return *best;
        const std::vector<Seam> parts = partsOf(*best);
        return *std::min_element(parts.begin(), parts.end(),
                                 [&](const Seam &a, const Seam &b) { return gapOf(a) < gapOf(b); });
    }

    //! The parts of a seam, each from one junction of seams to the next.
    std::vector<Seam> partsOf(const Seam &seam) const
    {
        std::map<int, int> firstAt; // edge at each vertex where a part goes on
        UnionFind edges(static_cast<int>(seam.edges.size()));
        for (int i = 0; i < static_cast<int>(seam.edges.size()); ++i) {
            for (const auto &ends : mMesh.edgePairs[seam.edges[i]].corner) {
                const int vertex = mMesh.vertexOfSoup(ends[0]);
                if (mSeamsAt[vertex] == 2)
                    edges.unite(firstAt.try_emplace(vertex, i).first->second, i);
            }
        }
        const auto [part, count] = edges.labels();
        std::vector<Seam> parts(count, Seam{seam.first, seam.second, {}});
        for (std::size_t i = 0; i < seam.edges.size(); ++i)
            parts[part[i]].add(seam.edges[i], mMesh.edgePairs[seam.edges[i]].length);
        return parts;
    }

    //! Mean distance of the two sides, relative to the length of the edges.
    double gapOf(const Seam &seam) const
    {
        double gap = 0;
        for (const int e : seam.edges) {
            for (const auto &ends : mMesh.edgePairs[e].corner)
                gap += (place(mMesh.cornerOfSoup(ends[0])) - place(mMesh.cornerOfSoup(ends[1]))).norm();
        }
        return gap / std::max(seam.length, std::numeric_limits<double>::min());
    }

    //! Closes what fits of a seam. \param seam out: what was closed
    SewOutcome closeFitting(Seam &seam)
    {
        const Seam part = fittingPart(seam);
        if (part.edges.empty())
            return SewOutcome::Folds;
        const SewOutcome outcome = close(part);
        if (outcome == SewOutcome::Sewn)
            seam = part;
        return outcome;
    }

    //! Closes a seam; when one between two islands cannot be closed, its longest part that can be. The rest
    //! of it is inside one island then. \param seam out: what was closed
    SewOutcome closeMost(Seam &seam)
    {
        const SewOutcome outcome = close(seam);
        if (seam.first == seam.second || (outcome != SewOutcome::Folds && outcome != SewOutcome::Covers))
            return outcome;
        std::vector<Seam> parts = partsOf(seam);
        if (parts.size() < 2)
            return outcome;
        std::stable_sort(parts.begin(), parts.end(),
                         [](const Seam &a, const Seam &b) { return a.length > b.length; });
        for (const Seam &part : parts) {
            if (close(part) == SewOutcome::Sewn) {
                seam = part;
                return SewOutcome::Sewn;
            }
        }
        return outcome;
    }

    //! What is to be closed of a seam before anything is relaxed: the edges that fit exactly or, where there
    //! are none, as well as any. The whole seam when all of it fits loosely, and when the rest could not be
    //! zipped later because an island is held.
    Seam fittingPart(const Seam &seam) const
    {
        const bool isZip = seam.first == seam.second;
        const std::vector<EdgeMatch> matches = matchesOf(movingOf(seam), seam.edges);
        const bool isHeld = mIslands[seam.first].isHeld() || mIslands[seam.second].isHeld();
        if (!isZip && isHeld)
            return seam;
        std::vector<int> fitting = isZip ? touchingEdges(matches) : exactEdges(matches);
        if (!isZip && fitting.empty()) {
            if (fitLoosely(matches))
                return seam;
            fitting = fittingEdges(matches);
        }
        Seam part{seam.first, seam.second, {}};
        for (const int i : fitting)
            part.add(seam.edges[i], mMesh.edgePairs[seam.edges[i]].length);
        return part;
    }

    //! The edges on both sides, the moving one turned over when its island is mirrored against the other one.
    std::vector<EdgeMatch> matchesOf(int moving, const std::vector<int> &edges) const
    {
        std::vector<EdgeMatch> matches;
        for (const int e : edges) {
            const EdgePair &pair = mMesh.edgePairs[e];
            const int side = islandOf(pair.triangle[0]) == moving ? 0 : 1;
            const bool turnOver = isMirrored(moving) != isMirrored(islandOf(pair.triangle[1 - side]));
            const auto match = [&](const std::array<int, 2> &ends) {
                return PointMatch{place(mMesh.cornerOfSoup(ends[1 - side])),
                                  turned(place(mMesh.cornerOfSoup(ends[side])), turnOver),
                                  std::max(pair.length, std::numeric_limits<double>::min())};
            };
            matches.push_back({match(pair.corner[0]), match(pair.corner[1])});
        }
        return matches;
    }

    bool isMirrored(int island) const { return mIslands[island].area < 0; }
    static Vec2 turned(const Vec2 &p, bool over) { return {over ? -p.x() : p.x(), p.y()}; }

    //! Which of the two islands moves.
    int movingOf(const Seam &seam) const
    {
        const Island &first = mIslands[seam.first], &second = mIslands[seam.second];
        if (first.isHeld() != second.isHeld())
            return first.isHeld() ? seam.second : seam.first;
        return std::abs(first.area) < std::abs(second.area) ? seam.first : seam.second;
    }

    //! Where the moved island would cover another part, sides that touch are closed without a move: a rip
    //! that found no room opened them by a small gap, and the islands may touch all along their other sides.
    SewOutcome close(const Seam &seam)
    {
        const bool isZip = seam.first == seam.second;
        const int moving = movingOf(seam), other = moving == seam.first ? seam.second : seam.first;
        if (mIslands[moving].locked || (!isZip && mIslands[moving].pinned))
            return SewOutcome::Held;
        UvMatrix placed = uv();
        if (isZip)
            return sew(seam, moving, other, placed);
        const SewOutcome outcome =
            moveTo(moving, other, seam.edges, placed) ? sew(seam, moving, other, placed) : SewOutcome::Folds;
        const bool touches = touchingEdges(matchesOf(moving, seam.edges)).size() == seam.edges.size();
        if (outcome == SewOutcome::Sewn || !touches || isMirrored(moving) != isMirrored(other))
            return outcome;
        placed = uv();
        return sew(seam, moving, other, placed);
    }

    //! \param placed the map with the moving island in its place
    SewOutcome sew(const Seam &seam, int moving, int other, UvMatrix &placed)
    {
        Sewing sewing{seam.edges, std::vector<FaceRole>(mMesh.faceCount(), FaceRole::Outside), mPinned,
                      mAsTheyFit};
        for (int f = 0; f < mMesh.faceCount(); ++f) {
            if (mTopology.charts.faceChart[f] == moving)
                sewing.role[f] = FaceRole::Moves;
            else if (mTopology.charts.faceChart[f] == other)
                sewing.role[f] = mIslands[other].isHeld() ? FaceRole::Held : FaceRole::Yields;
        }
        const SewOutcome outcome = sewSeams(*mSoup, mTopology, uv(), sewing, placed, mJob.quiet());
        if (outcome != SewOutcome::Sewn)
            return outcome;
        uv() = std::move(placed);
        keepOthersOpen(sewing);
        return SewOutcome::Sewn;
    }

    //! Moves an island to where its sides of the edges fit those of the other one best. False when there is
    //! no such place.
    bool moveTo(int moving, int other, const std::vector<int> &edges, UvMatrix &placed) const
    {
        const bool turnOver = isMirrored(moving) != isMirrored(other);
        const SimilarMotion motion = fitEdges(matchesOf(moving, edges));
        if (!(motion.scale() < largestScale && motion.scale() > 1 / largestScale))
            return false;
        for (int f = 0; f < mMesh.faceCount(); ++f) {
            if (mTopology.charts.faceChart[f] != moving)
                continue;
            for (int c = mMesh.faceStart[f]; c < mMesh.faceStart[f + 1]; ++c)
                placed.row(c) = motion(turned(place(c), turnOver)).transpose();
        }
        return true;
    }

    //! Opens the other seams of the islands where they would close because their sides fit.
    void keepOthersOpen(const Sewing &sewing)
    {
        std::vector<int> others;
        std::vector<bool> held(mMesh.faceCount());
        const auto isInside = [&](int triangle) {
            return sewing.role[mMesh.triangleFace[triangle]] != FaceRole::Outside;
        };
        for (int f = 0; f < mMesh.faceCount(); ++f)
            held[f] = sewing.role[f] == FaceRole::Outside || sewing.role[f] == FaceRole::Held;
        for (int e = 0; e < static_cast<int>(mMesh.edgePairs.size()); ++e) {
            const auto [first, second] = mMesh.edgePairs[e].triangle;
            if (!mMesh.edgePairs[e].diagonal && isSeam(e) && (isInside(first) || isInside(second)) &&
                !std::binary_search(sewing.edges.begin(), sewing.edges.end(), e))
                others.push_back(e);
        }
        openSides(mMesh, sidesOf(mMesh, others), held, uv());
    }

    const Snapshot &mSnapshot;
    const MeshData &mMesh;
    const JobContext &mJob;
    std::shared_ptr<const Soup> mSoup;
    std::vector<bool> mPinned; //!< per corner: hard
    std::set<int> mOpen;       //!< given seams that are not decided yet
    bool mAsTheyFit = true;    //!< seams are closed only where their sides fit
    UvTopology mTopology;      //!< of the present map
    std::vector<bool> mIsOpen; //!< per corner pair
    std::vector<int> mSeamsAt; //!< number of seam edges at each vertex
    std::vector<Island> mIslands;
    StitchedMap mResult;
};

} // namespace

StitchedMap stitchSeams(const Snapshot &snapshot, const std::vector<int> &edges, const JobContext &job)
{
    return SeamStitcher(snapshot, edges, job).stitch();
}

} // namespace autocuts::definite
