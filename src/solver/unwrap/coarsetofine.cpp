#include "solver/unwrap/coarsetofine.h"

#include "solver/base/constant.h"
#include "solver/base/cornerat.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/preference/seampreference.h"
#include "solver/preference/surfacekind.h"
#include "solver/search/anchoring.h"
#include "solver/search/seamrun.h"
#include "solver/search/seamtrial.h"
#include "solver/unwrap/coarsemesh.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Meshes of more triangles than this are coarsened first, whatever they are.
constexpr int largeMesh = 25'000;
//! The same for organic surfaces. Measured on 17 meshes of 4,200 to 20,000 triangles: against a search on the
//! mesh itself, seams in standard are .97 times as long (.92 to 1.06) in .45 of the CPU time (.18 to .9).
AUTOCUTS_CONSTANT(int, largeForSearches, 3'000);
//! The same in drafts; just below a number to which meshes are often reduced. Measured on 23 meshes of 10,000
//! to 24,000 triangles: against a draft of the mesh itself, seams are .92 times as long (.66 to 1.26) in .60
//! of the CPU time. From 4,500 on they got no shorter.
AUTOCUTS_CONSTANT(int, largeForDrafts, 9'990);
//! Share of hard surface from which meshes are not coarsened unless they are large: regions that are flat on
//! the coarse mesh are not quite those of the fine one. Measured: on a plate with holes .90 of the flat area
//! kept its shape, in place of all.
constexpr double hardlyHard = 0.1;
//! Share of the triangles that the coarse version has, and the fewest. Measured on these and one of 52,000,
//! with the search on the finer meshes below: seams in standard are .954 times as long in .48 of the CPU
//! time; with 1,000 or 2,500 in place of 1,500 they are .962 and .965 times as long, with a tenth .970 times,
//! in as much time. On 8 of 10,000 to 24,000, 6,000 triangles made them .960 times as long in .45 of the
//! time, in place of .35.
AUTOCUTS_CONSTANT(double, coarseReduction, 1.0 / 5);
constexpr double fewestCoarse = 1'500;
//! The most that it has of a hard surface, where it is searched as it is.
constexpr double mostOfHard = 6'000;
//! Bounds for the coarse map, as shares of (bound - 4). The distortion of the fine map usually gets lower,
//! because a finer mesh can bend more freely. The last share is tried when the fine map misses the bound.
//! Measured with two seeds on 8 meshes: with 1.4 in standard, seams are 1.005 times as long in .97 of the CPU
//! time. In drafts of 18 meshes, 1.2 makes them 1.014 times as long in .92 of it.
AUTOCUTS_CONSTANT(double, boundShare, 1.2);
AUTOCUTS_CONSTANT(double, draftBoundShare, 1.4);
constexpr double lastBoundShare = 0.9;
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
constexpr int stepsBetween = 5; // steps of relaxing after which the map is prepared for a stop
//! A coarse map whose distortion is further above the bound takes long to carry over to a large mesh; none of
//! those is made usable on the way.
constexpr double worthCarrying = 0.5, anyDistortion = std::numeric_limits<double>::infinity();
//! Multiple of the stretch allowed up to which a map of the fine mesh is taken to the bound, by more seams or
//! by shorter ones. Measured: from three times as much, that takes as long as the map itself; from 300 times
//! it took three times as long, in vain.
AUTOCUTS_CONSTANT(double, worthTaking, 4);
//! The effort of that in drafts. Measured on 6 meshes of 12,000 to 124,000 triangles: against no squeezes and
//! 16 moves, seams are .93 times as long (.86 to .98) in the same CPU time.
const search::OptimizeEffort draftEffort{0, {}, 2, 0.5, 64, 1, 2};
//! The same in the other qualities; large moves come first, from the heat below. Measured in standard on 8
//! meshes: against the effort of drafts, seams are .966 times as long in 1.09 times the CPU time. On 18
//! meshes, 600 moves made them .995 times as long in 1.06 times the time.
AUTOCUTS_CONSTANT(int, fineMoves, 300);
const search::OptimizeEffort standardEffort{0, {{fineMoves, 1}}, 10, 0.85, 64};
//! The same for large meshes, where it takes longest to relax the whole map. Measured on 5 of 25,000 to
//! 124,000 triangles: seams are 1.006 times as long in .87 of the CPU time.
const search::OptimizeEffort largeEffort{0, {{fineMoves, 1}}, 5, 0.7, 64, 1, 3};
const search::OptimizeEffort bestEffort{0, {{1300, 1}}, 10, 0.85, 64};
constexpr double fineHeat = 0.5;
//! Share of the progress at which the carried map is relaxed. A guess that only the progress depends on.
constexpr double relaxedShare = 0.3;

//! Gives all charts one texel density and puts them exactly onto their pins.
void settle(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const UnwrapOptions &options,
            int steps, Candidate &carried, const JobContext &job)
{
    definite::equalizeDensity(*soup, snapshot, carried.map);
    carried.anchorFaults = 0;
    if (!snapshot.placesIslands())
        return;
    const auto graph = search::SeamGraph::build(soup, snapshot);
    carried.anchorFaults = search::settleAtAnchors(graph, carried.map, steps, !options.allowOverlaps, job);
}

//! Makes a map usable in a hurry. Nothing when overlaps cannot be removed or the job is stopped.
std::optional<Candidate> usable(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                const UnwrapOptions &options, Candidate carried, const JobContext &job)
{
    if (!options.allowOverlaps && definite::coversItself(*soup, carried.map) &&
        !definite::removeOverlaps(*soup, snapshot, carried.map, job))
        return std::nullopt;
    settle(soup, snapshot, options, hurriedSteps, carried, job);
    if (job.stopped())
        return std::nullopt;
    carried.measure(*soup, snapshot);
    return carried;
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

//! Surface of which hardly a part counts as hard.
bool isHardlyHard(const Snapshot &snapshot)
{
    return preference::surfaceParts(*snapshot.mesh, snapshot.settings.surface).hardShare < hardlyHard;
}

search::OptimizeEffort fineEffort(UnwrapQuality quality, const MeshData &mesh)
{
    if (quality == UnwrapQuality::Draft)
        return draftEffort;
    return quality == UnwrapQuality::Best ? bestEffort : isLargeMesh(mesh) ? largeEffort : standardEffort;
}

//! The map with as many seams as the bound requires: more where it is missed, shorter ones where stretch is
//! left over. With rigid regions only more: they settle afterwards, which takes what is left over.
//! \param improved gets ever better maps
SeamedMap atBound(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                  const UnwrapOptions &options, const SeamedMap &map,
                  const std::function<void(SeamedMap)> &improved, const JobContext &job)
{
    Snapshot preferred = preference::SeamPreference().applied(snapshot, job.threads());
    search::OptimizeOptions search;
    search.maxDistortion = options.maxDistortion;
    search.allowOverlaps = options.allowOverlaps;
    search.effort = fineEffort(options.quality, *snapshot.mesh);
    if (std::exchange(preferred.rigid, nullptr)) {
        if (map.distortion(*soup) <= options.maxDistortion)
            return map;
        search.effort.rounds.clear();
        search.effort.squeezes = 0;
    }
    int moves = 0, made = 0;
    for (const search::OptimizeEffort::Round &round : search.effort.rounds)
        moves += round.moves;
    search.progress = [&](int steps) {
        made += steps;
        job.report(moves > 0 ? double(made) / moves : 0);
    };
    if (improved)
        search.improved = [&](const search::CutState &state) { improved(state.map()); };
    search.job = job.quiet();
    search::SeamRun run(
        search,
        search::CutState::from(search::SeamGraph::build(soup, preferred), map, snapshot.placesIslands()),
        snapshot.settings.seed);
    run.useThreads(job.threads());
    for (const search::OptimizeEffort::Round &round : search.effort.rounds)
        run.search(round.moves, fineHeat);
    run.takeToBound();
    return run.best().map();
}

//! Relaxes a carried map, removes overlaps unless they are allowed, and takes it to the bound.
//! \returns false when overlaps cannot be removed, or when the job is stopped before there is a map
bool relax(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const UnwrapOptions &options,
           Candidate &carried, const PrepareMap &prepare, const JobContext &job)
{
    const bool isDraft = options.quality == UnwrapQuality::Draft;
    Candidate relaxed = carried;
    const auto show = [&] {
        if (prepare)
            prepare([=](const JobContext &own) { return usable(soup, snapshot, options, relaxed, own); });
    };
    const JobContext relaxing = job.part(0, relaxedShare, JobStage::Refining);
    show();
    definite::relaxMap(
        soup, snapshot, relaxed.map, fineSteps, job,
        [&](int steps) {
            relaxing.report(double(steps) / fineSteps);
            if (steps % stepsBetween == 0)
                show();
        },
        isDraft ? hurriedGain : leastGain);
    if (job.stopped())
        return false;
    if (!options.allowOverlaps && definite::coversItself(*soup, relaxed.map)) {
        std::optional<SeamedMap> guarded = withoutOverlaps(soup, snapshot, carried.map, relaxed.map,
                                                           isDraft ? hurriedGuardedSteps : guardedSteps, job);
        if (!guarded)
            return false;
        // When that is no good map, the freely relaxed one with its overlaps cut off may be better.
        const double distortion = guarded->distortion(*soup);
        const bool isBetter = (options.lambda || isFarAboveBound(distortion, options)) && !job.stopped() &&
                              definite::removeOverlaps(*soup, snapshot, relaxed.map, job) &&
                              relaxed.map.distortion(*soup) < distortion;
        if (!isBetter)
            relaxed.map = std::move(*guarded);
    }
    const double distortion = relaxed.map.distortion(*soup);
    if (!options.lambda && !job.stopped() && !isFarAboveBound(distortion, options)) {
        show();
        std::function<void(SeamedMap)> improved;
        if (prepare)
            improved = [&](SeamedMap map) {
                relaxed.map = std::move(map);
                show();
            };
        SeamedMap found = atBound(soup, snapshot, options, relaxed.map, improved,
                                  job.part(relaxedShare, 1, JobStage::Refining));
        relaxed.map = std::move(found);
    }
    carried.map = std::move(relaxed.map);
    return true;
}

} // namespace

bool isLargeMesh(const MeshData &mesh)
{
    return mesh.triangleCount() > largeMesh;
}

bool isFarAboveBound(double distortion, const UnwrapOptions &options)
{
    return distortion > 4 + worthTaking * (options.maxDistortion - 4);
}

bool suitsCoarseToFine(const Snapshot &snapshot, const UnwrapOptions &options)
{
    if (snapshot.settings.start == StartMode::ExistingUv)
        return false;
    if (isLargeMesh(*snapshot.mesh))
        return true;
    const bool isDraft = options.quality == UnwrapQuality::Draft;
    const bool isHeld = snapshot.placesIslands() || snapshot.settings.seams != SeamMode::Free;
    if (options.lambda || (isHeld && !isDraft))
        return false;
    const int least = isDraft && !options.coarse ? largeForDrafts : largeForSearches;
    return snapshot.mesh->triangleCount() > least && isHardlyHard(snapshot);
}

int coarseTriangles(const Snapshot &snapshot)
{
    const double triangles = std::max(coarseReduction * snapshot.mesh->triangleCount(), fewestCoarse);
    return static_cast<int>(isHardlyHard(snapshot) ? triangles : std::min(triangles, mostOfHard));
}

std::optional<Candidate> mapByCoarse(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                     const UnwrapOptions &options, const CoarseSearch &search,
                                     const PrepareMap &prepare, const JobContext &job)
{
    const auto coarse = std::make_shared<const CoarseMesh>(soup, snapshot, search.triangles, job);
    if (job.stopped() || !coarse->isWorthIt())
        return std::nullopt;
    std::optional<Candidate> best;
    const double firstShare = options.quality == UnwrapQuality::Draft ? draftBoundShare : boundShare;
    for (const double share : {firstShare, lastBoundShare}) {
        UnwrapOptions coarseOptions = options;
        coarseOptions.pack = false;
        coarseOptions.coarse = true;
        coarseOptions.maxDistortion = 4 + share * (options.maxDistortion - 4);
        PrepareMap prepareCoarse;
        if (prepare)
            prepareCoarse =
                [=, worst = coarseOptions.maxDistortion +
                            (isLargeMesh(*soup->mesh) ? worthCarrying : anyDistortion)](MakeMap make) {
                    prepare([=, make = std::move(make)](const JobContext &own) -> std::optional<Candidate> {
                        std::optional<Candidate> found = make(own);
                        if (!found || found->onlyPatches || found->distortion > worst)
                            return std::nullopt;
                        std::optional<SeamedMap> map = coarse->carried(found->map, own);
                        if (!map)
                            return std::nullopt;
                        if (map->distortion(*soup) > options.maxDistortion)
                            definite::relaxMap(soup, snapshot, *map, hurriedSteps, own);
                        found->map = std::move(*map);
                        return usable(soup, snapshot, options, std::move(*found), own);
                    });
                };
        std::optional<Candidate> carried = search.find(coarse->snapshot(), coarseOptions, prepareCoarse);
        std::optional<SeamedMap> map;
        // After a stop there is time for that on small meshes only.
        const bool isHurried = job.stopped();
        if (carried && !(isHurried && (best || isLargeMesh(*soup->mesh))))
            map = coarse->carried(carried->map, isHurried ? job.unstoppable() : job);
        if (!map)
            break;
        carried->map = std::move(*map);
        if (isHurried)
            return usable(soup, snapshot, options, std::move(*carried), job.unstoppable().quiet());
        if (!relax(soup, snapshot, options, *carried, prepare, job))
            break;
        settle(soup, snapshot, options, fineSteps, *carried, job);
        if (job.stopped() && carried->anchorFaults > 0)
            break;
        const double distortion = carried->map.distortion(*soup);
        if (!best || distortion < best->map.distortion(*soup))
            best = std::move(carried);
        if (options.lambda || distortion <= options.maxDistortion || isFarAboveBound(distortion, options) ||
            job.stopped())
            break;
    }
    return best;
}

} // namespace autocuts::unwrap
