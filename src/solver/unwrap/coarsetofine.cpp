#include "solver/unwrap/coarsetofine.h"

#include "solver/base/constant.h"
#include "solver/base/cornerat.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/multires/maprefiner.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/preference/seampreference.h"
#include "solver/preference/surfacekind.h"
#include "solver/search/anchoring.h"
#include "solver/search/seamrun.h"
#include "solver/search/seamtrial.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Meshes of more triangles than this are coarsened first.
constexpr int largeMesh = 25'000;
//! The same in drafts; just below a number to which meshes are often reduced. Measured on 23 meshes of 10,000
//! to 24,000 triangles: against a draft of the mesh itself, seams are .92 times as long (.66 to 1.26) in .60
//! of the CPU time.
AUTOCUTS_CONSTANT(int, largeForDrafts, 9'990);
//! Share of hard surface from which drafts of such meshes do not: regions that are flat on the coarse mesh
//! are not quite those of the fine one. Measured: on a plate with holes .90 of the flat area kept its shape,
//! in place of all.
constexpr double hardlyHard = 0.1;
//! The coarse mesh has at most this share of the triangles, else coarsening is not worth the effort.
constexpr double leastReduction = 0.6;
//! Share of the triangles that the coarse version has in drafts, and the fewest that it has. Measured with
//! three seeds on 11 meshes of 10,000 to 20,000 triangles: against 6,000 triangles, and together with
//! hurriedGain, seams are 1.003 times as long (.91 to 1.07) in .79 of the CPU time. With a quarter of the
//! triangles they are 1.005 times as long in .84 of it, with an eighth 1.02 times in .78.
AUTOCUTS_CONSTANT(double, draftReduction, 1.0 / 6);
constexpr double fewestCoarse = 1'500;
//! Bounds for the coarse map, as shares of (bound - 4). The distortion of the fine map usually gets lower,
//! because a finer mesh can bend more freely. The second share is tried when the fine map misses the bound.
AUTOCUTS_CONSTANT(double, firstCoarseShare, 1.4);
const double coarseShares[] = {firstCoarseShare, 0.9};
AUTOCUTS_CONSTANT(int, fineSteps, 30); // relaxation steps on the fine mesh, at most
//! The same for charts that would overlap themselves. Measured: with 30 steps, D of lucy_o_f48275 is 4.0870
//! in place of 4.0890, that of three others is the same.
AUTOCUTS_CONSTANT(int, guardedSteps, 15);
//! Share of the energy above that of an isometry that a step gains at least. Measured on a noisy shape of
//! 86,000 triangles: 5 steps in place of 13, D 4.0911 in place of 4.0907.
AUTOCUTS_CONSTANT(double, leastGain, 1e-3);
//! The same in drafts: least gain of a step, and steps for charts that would overlap themselves. What is left
//! of the time shortens more seams in the search.
AUTOCUTS_CONSTANT(double, hurriedGain, 1e-2);
AUTOCUTS_CONSTANT(int, hurriedGuardedSteps, 5);
//! Steps in a hurry. Measured: 4 steps took a mesh of 124,000 triangles from 4.217 to below 4.1.
constexpr int hurriedSteps = 5;
//! Steps of relaxing after which a map is shown to CoarseSearch::relaxing.
constexpr int stepsBetween = 5;

//! Energy of a triangle from which refining has found no place for it. It becomes a chart of its own: it
//! would stop the steps of all others.
constexpr double lostEnergy = 1e6;
//! Multiple of the stretch allowed up to which a map of the fine mesh is taken to the bound, by more seams or
//! by shorter ones. Measured: from three times as much, that takes as long as the map itself; from 300 times
//! it took three times as long, in vain.
AUTOCUTS_CONSTANT(double, worthTaking, 4);
//! The effort of that. Measured in drafts of 6 meshes of 12,000 to 124,000 triangles: against no squeezes and
//! 16 moves, seams are .93 times as long (.86 to .98) in the same CPU time; in standard .95 and .86 times on
//! two.
const search::OptimizeEffort boundEffort{0, {}, 2, 0.5, 64};

using PointPair = std::pair<int, int>;

PointPair endsOf(const multires::ProgressiveMesh &mesh, int side)
{
    return std::minmax(mesh.point(side), mesh.point(multires::ProgressiveMesh::next(side)));
}

//! The user's cuts and joins: per edge, given by the points at its ends, the state at each end.
using Decisions = std::map<PointPair, std::array<std::pair<int, PairState>, 2>>;

//! Per edge pair: true when the user cut or joined it at either end.
std::vector<bool> decidedEdges(const Snapshot &snapshot)
{
    const std::vector<PairState> &states = snapshot.steering->pairState;
    std::vector<bool> decided(snapshot.mesh->edgePairs.size(), false);
    for (std::size_t p = 0; p < states.size(); ++p) {
        if (states[p] != PairState::Free)
            decided[p / 2] = true;
    }
    return decided;
}

//! Per edge pair: true when its ends must stay: decided edges, and those around triangles with a pin.
std::vector<bool> keptEdges(const Snapshot &snapshot, std::vector<bool> kept)
{
    std::vector<bool> pinned(snapshot.mesh->triangleCount(), false);
    for (const Pin &pin : snapshot.steering->pins)
        pinned[pin.soupCorner / 3] = true;
    for (std::size_t e = 0; e < kept.size() && !snapshot.steering->pins.empty(); ++e) {
        const auto [a, b] = snapshot.mesh->edgePairs[e].triangle;
        kept[e] = kept[e] || pinned[a] || pinned[b];
    }
    return kept;
}

Decisions decisionsOf(const Snapshot &snapshot, const multires::ProgressiveMesh &fine,
                      const std::vector<bool> &decided)
{
    Decisions decisions;
    for (std::size_t e = 0; e < decided.size(); ++e) {
        if (!decided[e])
            continue;
        const EdgePair &pair = snapshot.mesh->edgePairs[e];
        const int side = 3 * pair.triangle[0] + pair.side(0);
        auto &ends = decisions[endsOf(fine, side)];
        for (int end = 0; end < 2; ++end)
            ends[end] = {fine.point(pair.corner[end][0]), snapshot.steering->pairState[2 * e + end]};
    }
    return decisions;
}

//! Mean painted weight around each point of the fine mesh.
std::vector<double> pointWeights(const Snapshot &snapshot, const multires::ProgressiveMesh &fine)
{
    if (snapshot.steering->pairWeight.empty())
        return {};
    std::vector<double> sum(fine.pointCount(), 0.0), count(fine.pointCount(), 0.0);
    for (std::size_t p = 0; p < snapshot.steering->pairWeight.size(); ++p) {
        const int point = fine.point(snapshot.mesh->edgePairs[p / 2].corner[p % 2][0]);
        sum[point] += snapshot.steering->pairWeight[p];
        ++count[point];
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] = count[i] > 0 ? sum[i] / count[i] : 1;
    return sum;
}

//! Solver units of the coarse mesh per solver unit of the fine one.
double unitOf(const MeshData &coarse, const MeshData &fine)
{
    return std::sqrt(fine.area / coarse.area);
}

//! Adds the pins that act on triangles of the coarse mesh.
void addPins(const Snapshot &snapshot, const std::vector<int> &triangles, const MeshData &mesh,
             Steering &steering)
{
    if (!snapshot.placesIslands())
        return;
    const double unit = unitOf(mesh, *snapshot.mesh);
    std::vector<int> coarseTriangle(snapshot.mesh->triangleCount(), -1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        coarseTriangle[triangles[t]] = static_cast<int>(t);
    const auto coarseCorner = [&](int corner) {
        const int t = coarseTriangle[corner / 3];
        return t < 0 ? -1 : 3 * t + corner % 3;
    };
    for (Pin pin : snapshot.steering->pins) {
        pin.soupCorner = coarseCorner(pin.soupCorner);
        pin.target *= unit;
        if (pin.soupCorner >= 0)
            steering.pins.push_back(pin);
    }
}

//! A snapshot of the coarse mesh with the settings, cuts, joins, weights and pins of the fine one.
Snapshot coarseSnapshot(const Snapshot &snapshot, const std::shared_ptr<const MeshData> &mesh,
                        const multires::ProgressiveMesh &points, const std::vector<int> &triangles,
                        const Decisions &decisions, const std::vector<double> &weights)
{
    Snapshot coarse;
    coarse.mesh = mesh;
    coarse.settings = snapshot.settings;
    Steering &steering = coarse.editSteering();
    addPins(snapshot, triangles, *mesh, steering);
    if (!decisions.empty())
        steering.pairState.assign(mesh->cornerPairCount(), PairState::Free);
    if (!weights.empty())
        steering.pairWeight.assign(mesh->cornerPairCount(), 1.0);
    for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
        const EdgePair &pair = mesh->edgePairs[e];
        const auto pointOf = [&](int corner) { return points.point(3 * triangles[corner / 3] + corner % 3); };
        const int ends[2] = {pointOf(pair.corner[0][0]), pointOf(pair.corner[1][0])};
        const auto found = decisions.find(std::minmax(ends[0], ends[1]));
        for (int end = 0; end < 2; ++end) {
            if (!weights.empty())
                steering.pairWeight[2 * e + end] = 0.5 * (weights[ends[0]] + weights[ends[1]]);
            for (int i = 0; found != decisions.end() && i < 2; ++i) {
                if (found->second[i].first == ends[end])
                    steering.pairState[2 * e + end] = found->second[i].second;
            }
        }
    }
    return coarse;
}

//! Writes coordinates and cut flags of the coarse map to the remaining triangles of the fine mesh.
//! \param scale of the map
void setCoarseMap(const MeshData &coarse, const SeamedMap &map, double scale,
                  const std::vector<int> &triangles, const multires::ProgressiveMesh &points,
                  multires::MapRefiner &refiner)
{
    const auto uvOf = [&](int soupCorner) { return Vec2(cornerAt(map.x, soupCorner)); };
    for (int t = 0; t < coarse.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) {
            refiner.uv[3 * triangles[t] + k] = scale * uvOf(3 * t + k);
            refiner.cut[3 * triangles[t] + k] = 1;
        }
    }
    for (std::size_t e = 0; e < coarse.edgePairs.size(); ++e) {
        const EdgePair &pair = coarse.edgePairs[e];
        const int a = 3 * triangles[pair.triangle[0]] + pair.side(0);
        const int b = 3 * triangles[pair.triangle[1]] + pair.side(1);
        if (points.across(a) == b)
            refiner.cut[a] = refiner.cut[b] = map.cut[e];
    }
}

//! Total area of a map.
double areaOf(const SeamedMap &map)
{
    double area = 0;
    for (int c = 0; c < static_cast<int>(map.x.size() / 2); c += 3)
        area += 0.5 * cross2(cornerAt(map.x, c), cornerAt(map.x, c + 1), cornerAt(map.x, c + 2));
    return area;
}

//! Moves seams that run along polygon diagonals to polygon edges. At each such diagonal, the triangle at the
//! end of the polygon moves to the other side of the seam.
void leaveDiagonals(const Soup &soup, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<std::vector<int>> edgesOf(mesh.triangleCount());
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        for (const int t : mesh.edgePairs[e].triangle)
            edgesOf[t].push_back(static_cast<int>(e));
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (!pair.diagonal || !map.cut[e])
            continue;
        // The triangle with fewer diagonals moves; its edges that are no diagonals become seams.
        const auto diagonals = [&](int t) {
            return std::count_if(edgesOf[t].begin(), edgesOf[t].end(),
                                 [&](int other) { return mesh.edgePairs[other].diagonal; });
        };
        const int which = diagonals(pair.triangle[1]) < diagonals(pair.triangle[0]) ? 1 : 0;
        const int moving = pair.triangle[which];
        for (const int other : edgesOf[moving])
            map.cut[other] = other != static_cast<int>(e) && !mesh.edgePairs[other].diagonal;
        std::array<Vec2, 2> end, rest;
        for (int i = 0; i < 2; ++i) {
            const int own = pair.corner[i][which], other = pair.corner[i][1 - which];
            cornerAt(map.x, own) = cornerAt(map.x, other);
            end[i] = cornerAt(map.x, own);
            rest[i] = cornerAt(soup.restShape[moving], own % 3);
        }
        // The third corner keeps its position at rest relative to the diagonal, turned and scaled with it.
        const int third = 3 * moving + 3 - pair.corner[0][which] % 3 - pair.corner[1][which] % 3;
        const Vec2 far = cornerAt(soup.restShape[moving], third % 3);
        const Vec2 from = rest[1] - rest[0], to = end[1] - end[0], arm = far - rest[0];
        const double norm = from.squaredNorm();
        const double c = from.dot(to) / norm, s = (from.x() * to.y() - from.y() * to.x()) / norm;
        cornerAt(map.x, third) =
            Vec2(end[0].x() + c * arm.x() - s * arm.y(), end[0].y() + s * arm.x() + c * arm.y());
    }
}

//! Makes charts of single triangles that have hardly any area in the map. Those of larger polygons, and those
//! with an edge that the user joined, stay.
void isolateLost(const Soup &soup, const Snapshot &snapshot, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<char> lost(soup.triangleCount(), 0);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        const double *at = &map.x[6 * static_cast<std::size_t>(t)];
        lost[t] = mesh.trianglesOf(mesh.triangleFace[t]).size() == 1 &&
                  !(search::triangleEnergy(at, soup.basis[t]) < lostEnergy);
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        if (snapshot.isJoined(e)) {
            for (const int t : mesh.edgePairs[e].triangle)
                lost[t] = 0;
        }
    }
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        if (lost[c / 3])
            cornerAt(map.x, c) = cornerAt(soup.restShape[c / 3], c % 3);
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        const auto [one, other] = mesh.edgePairs[e].triangle;
        map.cut[e] = map.cut[e] || lost[one] || lost[other];
    }
}

//! The refined map as coordinates and cut flags of the fine mesh.
SeamedMap fineMap(const Soup &soup, const Snapshot &snapshot, const multires::MapRefiner &refiner)
{
    SeamedMap map;
    map.x.resize(soup.coordinateCount());
    for (std::size_t c = 0; c < refiner.uv.size(); ++c)
        cornerAt(map.x, static_cast<int>(c)) = refiner.uv[c];
    const MeshData &mesh = *soup.mesh;
    map.cut.resize(mesh.edgePairs.size());
    for (std::size_t e = 0; e < map.cut.size(); ++e)
        map.cut[e] = refiner.cut[3 * mesh.edgePairs[e].triangle[0] + mesh.edgePairs[e].side(0)] != 0;
    isolateLost(soup, snapshot, map);
    leaveDiagonals(soup, map);
    return map;
}

//! Gives all charts one texel density and puts them exactly onto their pins.
void settle(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const UnwrapOptions &options,
            int steps, CarriedMap &carried, const JobContext &job)
{
    definite::equalizeDensity(*soup, snapshot, carried.map);
    carried.anchorFaults = 0;
    if (!snapshot.placesIslands())
        return;
    const auto graph = search::SeamGraph::build(soup, snapshot);
    carried.anchorFaults = search::settleAtAnchors(graph, carried.map, steps, !options.allowOverlaps, job);
}

//! Makes a map usable in a hurry. Nothing when overlaps cannot be removed or the job is stopped.
std::optional<CarriedMap> usable(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                 const UnwrapOptions &options, CarriedMap carried, const JobContext &job)
{
    if (!options.allowOverlaps && definite::coversItself(*soup, carried.map) &&
        !definite::removeOverlaps(*soup, snapshot, carried.map, job))
        return std::nullopt;
    settle(soup, snapshot, options, hurriedSteps, carried, job);
    return job.stopped() ? std::nullopt : std::optional(std::move(carried));
}

//! A relaxed map in which charts may overlap themselves, without overlaps: those charts go back to where they
//! were, and are relaxed one by one with their boundaries barred.
//! \param before the map before it was relaxed \param steps at most
//! \returns nothing when overlaps cannot be removed
std::optional<SeamedMap> withoutOverlaps(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                         const SeamedMap &before, SeamedMap map, int steps,
                                         const JobContext &job)
{
    const CutMesh charts(*soup->mesh, map.cut);
    std::vector<char> covers(charts.chartCount, 0);
    overlap::visitOverlapsWithin(rowsOf(map.x), charts.chart, {}, [&](int t, int, double) {
        covers[charts.chart[t]] = 1;
        return true;
    });
    for (int c = 0; c < soup->mesh->soupCornerCount(); ++c) {
        if (covers[charts.chart[c / 3]])
            cornerAt(map.x, c) = cornerAt(before.x, c);
    }
    if (definite::coversItself(*soup, map) && !definite::removeOverlaps(*soup, snapshot, map, job))
        return std::nullopt;
    search::CutState state =
        search::CutState::from(search::SeamGraph::build(soup, snapshot), map, snapshot.placesIslands());
    std::vector<char> which(state.chartCount(), 0);
    for (int t = 0; t < soup->triangleCount(); ++t)
        which[state.chart[t]] |= covers[charts.chart[t]];
    search::SeamTrial trial(state);
    trial.barContacts();
    trial.relaxCharts(which, steps, true, job.quiet());
    job.addWork(trial.patch().work());
    return state.map();
}

//! The map with as many seams as the bound requires: more where it is missed, shorter ones where stretch is
//! left over. With rigid regions only more: they settle afterwards, which takes what is left over.
SeamedMap atBound(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                  const UnwrapOptions &options, const SeamedMap &map, const JobContext &job)
{
    Snapshot preferred = preference::SeamPreference().applied(snapshot, job.threads());
    search::OptimizeOptions search;
    search.maxDistortion = options.maxDistortion;
    search.allowOverlaps = options.allowOverlaps;
    search.effort = boundEffort;
    if (options.quality == UnwrapQuality::Draft) {
        search.effort.boundSteps = 1;
        search.effort.lastSteps = 2;
    }
    if (std::exchange(preferred.rigid, nullptr)) {
        if (map.distortion(*soup) <= options.maxDistortion)
            return map;
        search.effort.squeezes = 0;
    }
    search.job = job.quiet();
    search::SeamRun run(
        search,
        search::CutState::from(search::SeamGraph::build(soup, preferred), map, snapshot.placesIslands()),
        snapshot.settings.seed);
    run.takeToBound();
    return run.best().map();
}

//! Relaxes a carried map, removes overlaps unless they are allowed, and takes it to the bound.
//! \returns false when overlaps cannot be removed, or when the job is stopped before there is a map
bool relax(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const UnwrapOptions &options,
           CarriedMap &carried, const CoarseSearch &search, const JobContext &job)
{
    const bool isDraft = options.quality == UnwrapQuality::Draft;
    CarriedMap relaxed = carried;
    const auto show = [&] {
        if (search.relaxing)
            search.relaxing(
                [=](const JobContext &own) { return usable(soup, snapshot, options, relaxed, own); });
    };
    show();
    definite::relaxMap(
        soup, snapshot, relaxed.map, fineSteps, job,
        [&](int steps) {
            job.report(double(steps) / fineSteps);
            if (steps % stepsBetween == 0)
                show();
        },
        isDraft ? hurriedGain : leastGain);
    if (job.stopped())
        return false;
    const double tooFar = 4 + worthTaking * (options.maxDistortion - 4);
    if (!options.allowOverlaps && definite::coversItself(*soup, relaxed.map)) {
        std::optional<SeamedMap> guarded = withoutOverlaps(soup, snapshot, carried.map, relaxed.map,
                                                           isDraft ? hurriedGuardedSteps : guardedSteps, job);
        if (!guarded)
            return false;
        // When that is no good map, the freely relaxed one with its overlaps cut off may be better.
        const double distortion = guarded->distortion(*soup);
        const bool isBetter = (options.lambda || distortion > tooFar) && !job.stopped() &&
                              definite::removeOverlaps(*soup, snapshot, relaxed.map, job) &&
                              relaxed.map.distortion(*soup) < distortion;
        if (!isBetter)
            relaxed.map = std::move(*guarded);
    }
    const double distortion = relaxed.map.distortion(*soup);
    if (!options.lambda && !job.stopped() && distortion <= tooFar) {
        show();
        relaxed.map = atBound(soup, snapshot, options, relaxed.map, job);
    }
    carried.map = std::move(relaxed.map);
    return true;
}

//! The coarse version of a mesh, and the way back from it.
class CoarseProblem
{
public:
    CoarseProblem(std::shared_ptr<const Soup> soup, const Snapshot &snapshot, int triangles,
                  const JobContext &job)
        : mSoup(std::move(soup)), mSnapshot(snapshot), mKept(decidedEdges(snapshot)),
          mMesh(*mSoup->mesh, keptEdges(snapshot, mKept)), mDecisions(decisionsOf(snapshot, mMesh, mKept)),
          mWeights(pointWeights(snapshot, mMesh)),
          mPreferred(pointWeights(preference::SeamPreference().applied(snapshot, job.threads()), mMesh))
    {
        mMesh.coarsen(triangles, job);
        mCoarse = mMesh.extract(mTriangles);
    }

    bool isWorthIt() const { return mMesh.triangleCount() <= leastReduction * mSoup->triangleCount(); }
    Snapshot snapshot() const
    {
        return coarseSnapshot(mSnapshot, mCoarse, mMesh, mTriangles, mDecisions, mWeights);
    }

    //! The map of the fine mesh, stitched but not relaxed; it may overlap itself. Nothing when the job is
    //! stopped. \param coarse of the coarse mesh
    std::optional<SeamedMap> carried(const SeamedMap &coarse, const JobContext &job) const
    {
        multires::ProgressiveMesh mesh = mMesh;
        multires::MapRefiner refiner(mesh, mSoup->scale);
        refiner.uv.assign(mSoup->mesh->soupCornerCount(), Vec2::Zero());
        refiner.cut.assign(mSoup->mesh->soupCornerCount(), 0);
        refiner.pointCost = mPreferred;
        refiner.mayStraighten = mDecisions.empty();
        // A map that nothing holds gets the area that the triangles are to have.
        double target = 0;
        for (int t = 0; t < mSoup->triangleCount(); ++t)
            target += mSoup->mesh->targetArea(t);
        const double scale =
            mSnapshot.placesIslands()
                ? 1 / unitOf(*mCoarse, *mSoup->mesh)
                : std::sqrt(std::numbers::pi * (target / mSoup->mesh->area) / areaOf(coarse));
        setCoarseMap(*mCoarse, coarse, scale, mTriangles, mesh, refiner);
        refiner.refineTo(mSoup->triangleCount(), job);
        if (job.stopped())
            return std::nullopt;
        SeamedMap map = fineMap(*mSoup, mSnapshot, refiner);
        if (!map.validate(*mSoup).empty())
            map = definite::stitchTo(mSoup, mSnapshot, map.cut, map.x, job);
        return job.stopped() ? std::nullopt : std::optional(std::move(map));
    }

private:
    const std::shared_ptr<const Soup> mSoup;
    const Snapshot mSnapshot;
    const std::vector<bool> mKept;
    multires::ProgressiveMesh mMesh; //!< coarse
    const Decisions mDecisions;
    const std::vector<double> mWeights, mPreferred;
    std::shared_ptr<const MeshData> mCoarse;
    std::vector<int> mTriangles; //!< of the coarse mesh: their numbers in the fine one
};

} // namespace

bool isLargeMesh(const MeshData &mesh)
{
    return mesh.triangleCount() > largeMesh;
}

int coarseTriangles(const MeshData &mesh, UnwrapQuality quality)
{
    constexpr double most = CoarseSearch::mostCoarseTriangles;
    if (quality != UnwrapQuality::Draft)
        return most;
    return static_cast<int>(std::clamp(draftReduction * mesh.triangleCount(), fewestCoarse, most));
}

bool suitsCoarseToFine(const Snapshot &snapshot, UnwrapQuality quality)
{
    if (snapshot.settings.start == StartMode::ExistingUv)
        return false;
    return isLargeMesh(*snapshot.mesh) ||
           (quality == UnwrapQuality::Draft && snapshot.mesh->triangleCount() > largeForDrafts &&
            preference::surfaceParts(*snapshot.mesh, snapshot.settings.surface).hardShare < hardlyHard);
}

std::optional<CarriedMap> mapByCoarse(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                      const UnwrapOptions &options, const CoarseSearch &search,
                                      const JobContext &job)
{
    const auto problem = std::make_shared<const CoarseProblem>(soup, snapshot, search.triangles, job);
    if (job.stopped() || !problem->isWorthIt())
        return std::nullopt;
    const CarryOver carryOver = [=](CarriedMap coarse, const JobContext &own) -> std::optional<CarriedMap> {
        std::optional<SeamedMap> map = problem->carried(coarse.map, own);
        if (map && map->distortion(*soup) > options.maxDistortion)
            definite::relaxMap(soup, snapshot, *map, hurriedSteps, own);
        if (!map)
            return std::nullopt;
        coarse.map = std::move(*map);
        return usable(soup, snapshot, options, std::move(coarse), own);
    };
    std::optional<CarriedMap> best;
    for (const double share : coarseShares) {
        UnwrapOptions coarseOptions = options;
        coarseOptions.pack = false;
        coarseOptions.coarse = true;
        coarseOptions.maxDistortion = 4 + share * (options.maxDistortion - 4);
        std::optional<CarriedMap> carried = search.unwrap(problem->snapshot(), coarseOptions, carryOver);
        std::optional<SeamedMap> map;
        if (carried && !job.stopped())
            map = problem->carried(carried->map, job);
        if (!map)
            break;
        carried->map = std::move(*map);
        if (!relax(soup, snapshot, options, *carried, search, job))
            break;
        settle(soup, snapshot, options, fineSteps, *carried, job);
        if (job.stopped() && carried->anchorFaults > 0)
            break;
        const double distortion = carried->map.distortion(*soup);
        if (!best || distortion < best->map.distortion(*soup))
            best = std::move(carried);
        if (options.lambda || distortion <= options.maxDistortion || job.stopped())
            break;
    }
    return best;
}

} // namespace autocuts::unwrap
