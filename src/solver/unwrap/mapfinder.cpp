#include "solver/unwrap/mapfinder.h"

#include "solver/base/constant.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/rigidsettling.h"
#include "solver/preference/seampreference.h"
#include "solver/search/seamtrial.h"
#include "solver/unwrap/alikeparts.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/flatpatches.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/mapsearch.h"
#include "solver/unwrap/symmetricseams.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Where only the given seams may be seams there is no bound on the distortion. Above all that users can ask
//! for.
constexpr double noBound = 1e9;
constexpr double dearSeam = 100;   // factor on the cost of a seam that is not given
constexpr int relaxSteps = 200;    // Newton steps for a map whose seams stay
constexpr double leastGain = 1e-9; // energy gained in ten steps below which relaxing ends

//! Share of the progress that is for the search on the coarse mesh. A guess that only the progress depends
//! on.
constexpr double coarseShare = 0.55;
//! The same for the search in standard quality that one in best quality begins with.
constexpr double standardShare = 0.25;

//! Meshes of more triangles are not searched as they are. Measured on a pram of thin tubes of 189,000
//! triangles, made as generators of models do: its version of 38,000 misses the bound by far by way of a
//! coarser one; searched as it is, a draft of the pram has D 4.099 in place of 7.06, in .7 of the CPU time.
AUTOCUTS_CONSTANT(int, mostAsItIs, 50'000);

//! Share of the stretch allowed that is left for what copies differ by.
constexpr double copyTolerance = 1e-4;

//! Makes the rigid regions of a large mesh keep their shape: those of the coarse mesh are not quite the same.
void settleCarried(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                   const UnwrapOptions &options, const JobContext &job, Candidate &carried)
{
    const Snapshot preferred = preference::SeamPreference().applied(snapshot, job.threads());
    if (!preferred.rigid || job.stopped())
        return;
    search::OptimizeOptions search;
    search.maxDistortion = options.maxDistortion;
    search.allowOverlaps = options.allowOverlaps;
    search.effort = effortFor(options.quality, snapshot.mesh->triangleCount());
    search.seed = snapshot.settings.seed;
    search.job = job.quiet();
    carried.map = definite::settleRigidRegions(search::SeamGraph::build(soup, preferred), preferred, search,
                                               std::move(carried.map), muOf(carried.lambda));
    definite::equalizeDensity(*soup, snapshot, carried.map);
}

//! True when a map that was found by way of a coarser mesh is taken, and no other one looked for. What is
//! thin may be lost on a coarser mesh: then a map of that does not meet the bound.
bool isGoodEnough(const Candidate &carried, const MeshData &mesh, const UnwrapOptions &options)
{
    if (carried.distortion <= options.maxDistortion || mesh.triangleCount() > mostAsItIs)
        return true;
    return isLargeMesh(mesh) && !isFarAboveBound(carried.distortion, options);
}

//! Finds the map by way of a coarser mesh; nothing when that fails.
std::optional<FoundMap> carriedFromCoarse(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                          const UnwrapOptions &options, const JobContext &job,
                                          const PrepareMap &prepare)
{
    FoundMap result;
    const JobContext searching = job.part(0, coarseShare);
    CoarseSearch search;
    search.triangles = coarseTriangles(snapshot);
    search.find = [&](const Snapshot &coarse, const UnwrapOptions &coarseOptions,
                      const PrepareMap &prepareCoarse) -> std::optional<Candidate> {
        Ranking ranking(coarseOptions, searching);
        FoundMap found = findMap(coarse, coarseOptions, ranking, searching, prepareCoarse);
        result.iterations += found.iterations;
        if (found.best.onlyPatches || found.onlyReady)
            return std::nullopt;
        return std::move(found.best);
    };
    const JobContext refining = job.part(coarseShare, Ranking::optimizingShare, JobStage::Refining);
    std::optional<Candidate> carried = mapByCoarse(soup, snapshot, options, search, prepare, refining);
    if (!carried)
        return std::nullopt;
    if (!options.lambda)
        settleCarried(soup, snapshot, options, job, *carried);
    carried->measure(*soup, snapshot);
    result.best = std::move(*carried);
    return result;
}

//! Finds the map by way of a coarser mesh; nothing when the mesh is not suited or that fails.
std::optional<FoundMap> findByCoarse(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                     const UnwrapOptions &options, const JobContext &job,
                                     const PrepareMap &prepare)
{
    if (!suitsCoarseToFine(snapshot, options))
        return std::nullopt;
    if (options.quality != UnwrapQuality::Best || options.coarse)
        return carriedFromCoarse(soup, snapshot, options, job, prepare);
    // Begins with the standard quality, so that the result is never worse.
    UnwrapOptions standard = options;
    standard.quality = UnwrapQuality::Standard;
    std::optional<FoundMap> first =
        carriedFromCoarse(soup, snapshot, standard, job.part(0, standardShare), prepare);
    if (job.stopped())
        return first;
    std::optional<FoundMap> best =
        carriedFromCoarse(soup, snapshot, options, job.part(standardShare, 1), prepare);
    if (first && (!best || Ranking(options, job).better(first->best, best->best)))
        return first;
    return best;
}

//! Finds the map of a mesh with alike parts from that of one part of each kind; nothing when there are none,
//! or when their map does not fit its copies.
std::optional<FoundMap> findOneOfEachKind(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                          const UnwrapOptions &options, const JobContext &job,
                                          const PrepareMap &prepare)
{
    const auto parts = [&]() -> std::shared_ptr<const AlikeParts> {
        std::optional<AlikeParts> found = AlikeParts::of(snapshot, job);
        return found ? std::make_shared<const AlikeParts>(std::move(*found)) : nullptr;
    }();
    if (!parts)
        return std::nullopt;
    const auto whole = [soup, parts, snapshot](Candidate found,
                                               const JobContext &context) -> std::optional<Candidate> {
        found.map = parts->expanded(found.map, context);
        if (!found.map.validate(*soup).empty())
            return std::nullopt;
        definite::equalizeDensity(*soup, snapshot, found.map);
        found.measure(*soup, snapshot);
        return found;
    };
    UnwrapOptions own = options;
    // Room for what copies differ by.
    own.maxDistortion -= copyTolerance * (own.maxDistortion - 4);
    Ranking ranking(own, job);
    ranking.setReported([&](const Candidate &best) { return parts->seamLength(best.map.cut, *soup); });
    PrepareMap prepareWhole;
    if (prepare) {
        prepareWhole = [&](MakeMap make) {
            prepare([whole, make = std::move(make)](const JobContext &context) -> std::optional<Candidate> {
                std::optional<Candidate> made = make(context);
                return made ? whole(std::move(*made), context) : std::nullopt;
            });
        };
    }
    FoundMap found = findMap(parts->snapshot(), own, ranking, job, prepareWhole);
    if (snapshot.settings.symmetry == SymmetryMode::On)
        found.symmetry = 0;
    if (found.onlyReady)
        return found;
    std::optional<Candidate> best = whole(std::move(found.best), job.quiet());
    if (!best)
        return std::nullopt;
    found.best = std::move(*best);
    return found;
}

//! The map whose seams are only the given ones, with the least distortion; nothing when a chart would be
//! closed or overlap itself. \pre all other edges are joined
std::optional<FoundMap> onlyGivenSeams(const Snapshot &snapshot, const JobContext &job)
{
    const std::shared_ptr<const Soup> soup = Soup::build(snapshot.mesh);
    const auto graph = search::SeamGraph::build(soup, snapshot);
    search::OptimizeOptions search;
    search.maxDistortion = noBound;
    search.effort = {0, {{0, 1}}};
    search.job = job.quiet();
    std::optional<FoundMap> best;
    const auto keepBetter = [&](SeamedMap map) {
        Candidate candidate;
        candidate.map = std::move(map);
        definite::equalizeDensity(*soup, snapshot, candidate.map);
        candidate.measure(*soup, snapshot);
        if (!best || candidate.distortion < best->best.distortion)
            best = FoundMap{std::move(candidate), 0, {}};
    };
    if (std::optional<search::OptimizedMap> flat = search::optimizeSeams(graph, search))
        keepBetter(std::move(flat->map));
    // The map before may be another minimum, when it has these seams.
    if (std::optional<search::CutState> before = steeredMapBefore(graph, snapshot, job.quiet())) {
        search::SeamTrial trial(*before);
        for (int i = 0; i < relaxSteps / 10; ++i) {
            if (trial.relaxAll(10, true, job.quiet()) < leastGain)
                break;
        }
        keepBetter(before->map());
    }
    return best;
}

//! Other seams than the given ones may be added, but only where there is no other way.
Snapshot withDearSeams(const Snapshot &snapshot)
{
    Snapshot loose = snapshot;
    Steering &steering = loose.editSteering();
    steering.pairWeight.resize(snapshot.mesh->cornerPairCount(), 1);
    for (std::size_t p = 0; p < steering.pairState.size(); ++p) {
        if (steering.pairState[p] != PairState::Joined)
            continue;
        steering.pairState[p] = PairState::Free;
        steering.pairWeight[p] *= dearSeam;
    }
    return loose;
}

//! Takes a map with symmetric seams in place of a free one, where these hardly cost more.
void preferSymmetric(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                     const UnwrapOptions &options, Ranking &ranking, const JobContext &job,
                     const preference::MeshSymmetry &symmetry, FoundMap &found)
{
    ranking.offer(found.best, [&] { return found.best.map; });
    const Snapshot preferred = preference::SeamPreference().applied(snapshot, job.threads());
    std::optional<Candidate> symmetric =
        searchSymmetric(soup, preferred, options, ranking, job, symmetry, found.best, found.iterations);
    if (!symmetric)
        return;
    found.best = std::move(*symmetric);
    found.symmetry = preference::symmetricShare(*snapshot.mesh, symmetry, found.best.map.cut);
}

//! Searches on the mesh itself. The map is empty when there is none.
FoundMap findAsItIs(const std::shared_ptr<const Soup> &soup, Snapshot snapshot, const UnwrapOptions &options,
                    Ranking &ranking, const JobContext &job, const WishedSymmetry &symmetry)
{
    FoundMap found;
    if (options.lambda)
        snapshot.settings.flat = FlatMode::Free;
    snapshot = preference::SeamPreference().applied(snapshot, job.threads());
    const auto search = [&] {
        return searchMap(soup, snapshot, options, ranking, job, symmetry, found.iterations);
    };
    std::optional<Candidate> best = search();
    if (snapshot.rigid && !job.stopped() && (!best || best->distortion > options.maxDistortion)) {
        // The curved parts alone cannot take the stretch that is allowed.
        snapshot.rigid = nullptr;
        std::optional<Candidate> other = search();
        if (other && (!best || ranking.better(*other, *best)))
            best = std::move(other);
    }
    if (best)
        found.best = std::move(*best);
    if (symmetry.required)
        found.symmetry = 0;
    if (best && symmetry.plane && (symmetry.required || found.best.symmetric))
        found.symmetry = preference::symmetricShare(*snapshot.mesh, *symmetry.plane, found.best.map.cut);
    found.symmetryMissed = symmetry.required && symmetry.plane && !found.best.symmetric && !job.stopped();
    return found;
}

} // namespace

Candidate patchesOf(const Snapshot &given)
{
    const std::shared_ptr<const Soup> soup = Soup::build(given.mesh);
    Candidate candidate;
    candidate.map = flatPatches(*soup, given);
    candidate.onlyPatches = true;
    candidate.measure(*soup, given);
    return candidate;
}

FoundMap findMap(const Snapshot &given, const UnwrapOptions &options, Ranking &ranking, const JobContext &job,
                 const PrepareMap &prepare)
{
    if (given.settings.seams == SeamMode::Only && options.maxDistortion < noBound) {
        if (std::optional<FoundMap> found = onlyGivenSeams(given, job))
            return std::move(*found);
        UnwrapOptions unbounded = options;
        unbounded.maxDistortion = noBound;
        return findMap(withDearSeams(given), unbounded, ranking, job, prepare);
    }
    const std::shared_ptr<const Soup> soup = Soup::build(given.mesh);
    Snapshot snapshot = given;
    // Decided on the mesh itself: a coarser version has sharper edges, which would look like creases.
    if (suitsCoarseToFine(snapshot, options))
        snapshot.settings = preference::decidedForAll(snapshot.settings, snapshot.mesh);
    const bool asked = snapshot.settings.symmetry == SymmetryMode::On;
    std::optional<preference::MeshSymmetry> symmetry;
    if (asked)
        symmetry = preference::findSymmetry(*snapshot.mesh, preference::Exactness::Loose, job);
    else if (!isLargeMesh(*snapshot.mesh))
        symmetry = openSymmetry(snapshot, options, job);
    const bool mustBe = asked && symmetry;
    std::optional<FoundMap> coarsely;
    // Not for symmetric cuts: the coarse mesh would not be symmetric.
    if (!mustBe) {
        if (!options.lambda) {
            if (std::optional<FoundMap> alike = findOneOfEachKind(soup, snapshot, options, job, prepare))
                return std::move(*alike);
        }
        Snapshot free = snapshot;
        free.settings.symmetry = SymmetryMode::Off;
        coarsely = findByCoarse(soup, free, options, symmetry ? job.part(0, freeShare) : job, prepare);
        if (coarsely && symmetry && !job.stopped())
            preferSymmetric(soup, snapshot, options, ranking, job, *symmetry, *coarsely);
        else if (coarsely && asked)
            coarsely->symmetry = 0;
        if (coarsely &&
            (options.lambda || job.stopped() || isGoodEnough(coarsely->best, *snapshot.mesh, options)))
            return std::move(*coarsely);
    }
    if (job.stopped()) {
        FoundMap found;
        if (prepare)
            found.onlyReady = true;
        else
            found.best = patchesOf(given);
        return found;
    }
    if (prepare)
        ranking.setWatcher(
            [prepare](const Candidate &best) { prepare([best](const JobContext &) { return best; }); });
    UnwrapOptions quick = options;
    if (coarsely && isLargeMesh(*snapshot.mesh))
        quick.quality = UnwrapQuality::Draft; // the others would take minutes
    FoundMap found =
        findAsItIs(soup, snapshot, quick, ranking, job, {symmetry ? &*symmetry : nullptr, asked});
    if (coarsely && (found.best.map.x.empty() || ranking.better(coarsely->best, found.best)))
        return std::move(*coarsely);
    if (found.best.map.x.empty()) {
        found.onlyReady = prepare && job.stopped();
        if (!found.onlyReady)
            found.best = patchesOf(given);
    }
    return found;
}

} // namespace autocuts::unwrap
