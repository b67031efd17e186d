#include "solver/unwrap/mapfinder.h"

#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/rigidsettling.h"
#include "solver/preference/seampreference.h"
#include "solver/search/anchoring.h"
#include "solver/search/resteering.h"
#include "solver/search/seamtrial.h"
#include "solver/unwrap/alikeparts.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/flatpatches.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/netstarts.h"
#include "solver/unwrap/soupchains.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

//! Smaller meshes get another effort. Chosen by hand, not measured.
constexpr double fullEffortTriangles = 2000;

//! Effort on a mesh of fullEffortTriangles or more. The rounds were chosen by hand; no comparison with
//! other plans is on record. Measured for the whole unwrap in draft, standard and best: seams are 1.10, .794
//! and .771 times as long as those of OptCuts on 14 meshes used in development (in 1/61, 1/5.4 and 1/1.9 of
//! its CPU time), and 1.13, .854 and .834 times as long on 18 other meshes.
search::OptimizeEffort fullEffort(UnwrapQuality quality)
{
    switch (quality) {
    case UnwrapQuality::Draft:
        return {1, {{0, 1}, {25, 1}}, 0, 0.5, 16};
    case UnwrapQuality::Standard:
        return {10, {{80, 5}, {200, 2}, {1300, 1}}, 10};
    case UnwrapQuality::Best:
        return {24, {{100, 12}, {300, 6}, {800, 3}, {2000, 1}}, 10};
    }
    throw std::invalid_argument("unknown quality");
}

//! Least share of the distortion in the energy, for lambda near 1. Chosen by hand.
constexpr double smallestShare = 1e-9;
//! Where only the given seams may be seams there is no bound on the distortion. Above all that users can ask
//! for.
constexpr double noBound = 1e9;
constexpr double dearSeam = 100; // factor on the cost of a seam that is not given; chosen by hand
constexpr int relaxSteps = 200;  // Newton steps for a map whose seams stay; chosen by hand
//! A map whose distortion is further above the bound takes long to carry to a finer mesh; none of those is
//! made ready for a stop.
constexpr double worthCarrying = 0.5;
constexpr double leastGain = 1e-9; // energy gained in ten steps below which relaxing ends
constexpr int settleSteps = 20;    // Newton steps before hard pins are reached; chosen by hand

//! True when the surface has several connected components or borders, or handles. Its first cuts are not few,
//! so that the search also starts from a map of the soup.
bool isComplicated(const MeshData &mesh)
{
    const CutMesh whole(mesh, CutFlags(mesh.edgePairs.size(), false));
    const int loops = static_cast<int>(whole.boundaryLoops().size());
    const int edges = static_cast<int>(mesh.edgePairs.size() + mesh.boundarySides.size());
    const int euler = whole.uvVertexCount - edges + mesh.triangleCount();
    return whole.chartCount > 1 || loops > 1 || euler + loops < 2;
}

//! Share of the area in rigid regions from which nets are better first maps than few cuts. Chosen by hand.
constexpr double mostlyRigid = 0.95;

//! Finds the best map of one unwrap, by the seam search and by the soup.
class MapFinder
{
public:
    //! \param snapshot with the preferences in its weights
    MapFinder(std::shared_ptr<const Soup> soup, const Snapshot &snapshot, const UnwrapOptions &options,
              Ranking &ranking, const JobContext &job)
        : mSoup(std::move(soup)), mSnapshot(snapshot), mOptions(options), mJob(job), mRanking(ranking),
          mGraph(search::SeamGraph::build(mSoup, snapshot))
    {
        if (!snapshot.steering->pins.empty() || snapshot.settings.seams == SeamMode::Keep)
            mBefore = steeredMapBefore(mGraph, snapshot, job);
    }

    int iterations() const { return mIterations; }

    //! Nothing when there is no map. \param symmetry null: cuts need not be symmetric
    std::optional<Candidate> find(const preference::MeshSymmetry *symmetry)
    {
        std::optional<Candidate> best = search(symmetry);
        if (mJob.stopped() || !best || !isWithinBound(*best)) {
            if (std::optional<Candidate> earlier = mRanking.best(); earlier && makeUsable(*earlier))
                keepBetter(best, std::move(earlier));
        }
        if (!best && mBefore) {
            best = measuresOf(*mBefore);
            best->map = mBefore->map();
        }
        return best;
    }

private:
    std::optional<Candidate> search(const preference::MeshSymmetry *symmetry)
    {
        std::optional<Candidate> best;
        if (symmetry)
            best = bySearch({}, symmetry);
        if (mJob.stopped() || (best && isWithinBound(*best)))
            return best;
        // Only the soup can start from existing UVs.
        if (mOptions.lambda)
            best = bySoup(mOptions.quality);
        else if (mSnapshot.settings.start == StartMode::ExistingUv ||
                 (isComplicated(*mSnapshot.mesh) && !startsFromNets()) ||
                 (mSnapshot.placesIslands() && !mBefore))
            best = bySoup(UnwrapQuality::Draft);
        std::optional<Candidate> searched = bySearch(best, nullptr);
        if (mSnapshot.rigid && searched && isWithinBound(*searched))
            best = std::move(searched); // in the map of the soup, rigid regions bend
        else
            keepBetter(best, std::move(searched));
        if (mJob.stopped())
            return best;
        if (!best || (!mOptions.lambda && !isWithinBound(*best)))
            keepBetter(best, bySoup(mOptions.quality));
        else if (best->anchorFaults > 0 && mBefore)
            keepBetter(best, bySoup(UnwrapQuality::Draft)); // it tears where pins contradict each other
        return best;
    }

    //! The best map of the seam search. \param other a further map to start from
    std::optional<Candidate> bySearch(const std::optional<Candidate> &other,
                                      const preference::MeshSymmetry *symmetry)
    {
        search::OptimizeOptions search;
        search.maxDistortion = mOptions.maxDistortion;
        if (mOptions.lambda)
            search.mu = *mOptions.lambda / std::max(1 - *mOptions.lambda, smallestShare);
        search.allowOverlaps = mOptions.allowOverlaps;
        search.effort = effortFor(mOptions.quality, mSnapshot.mesh->triangleCount());
        search.seed = mSnapshot.settings.seed;
        search.job = mJob;
        const bool steers = !symmetry && hasDecidedEdges();
        const bool isBest = mOptions.quality == UnwrapQuality::Best;
        const int searches = 1 + steers + isBest;
        int begun = 0;
        search.start = [&](int steps) {
            mRanking.setTotal(searches * steps);
            mRanking.stepDone(begun++ * steps);
        };
        search.progress = [&](int steps) { mRanking.stepDone(steps); };
        if (steers) {
            if (std::optional<SeamedMap> free = steeredFreeMap(search))
                search.given.push_back(std::move(*free));
        }
        if (other)
            search.given.push_back(other->map);
        if (mBefore)
            search.given.push_back(mBefore->map());
        if (!symmetry)
            startFromNets(search);
        search.improved = [&](const search::CutState &state) {
            mRanking.offer(measuresOf(state), [&] { return state.map(); });
        };
        const auto graph = symmetry ? search::SeamGraph::build(mSoup, mSnapshot, symmetry) : mGraph;
        if (isBest) {
            // Begins with the result of the standard quality, so that it is never worse.
            search::OptimizeOptions standard = search;
            standard.effort = effortFor(UnwrapQuality::Standard, mSnapshot.mesh->triangleCount());
            if (std::optional<search::OptimizedMap> found = search::optimizeSeams(graph, standard)) {
                search.given.push_back(std::move(found->map));
                mIterations += found->iterations;
            }
        }
        std::optional<search::OptimizedMap> found = search::optimizeSeams(graph, search);
        if (!found)
            return std::nullopt;
        Candidate candidate;
        candidate.anchorFaults = found->anchorFaults;
        candidate.lambda = mOptions.lambda.value_or(found->mu / (1 + found->mu));
        mIterations += found->iterations;
        candidate.map =
            definite::settleRigidRegions(graph, mSnapshot, search, std::move(found->map), found->mu);
        return makeUsable(candidate) ? std::optional(std::move(candidate)) : std::nullopt;
    }

    //! True when nets of rigid regions are nearer to the end than maps with few cuts, and than the soup.
    bool startsFromNets() const { return mSnapshot.rigid && mSnapshot.rigid->share >= mostlyRigid; }

    //! Adds maps of nets to start from. Where most is rigid they take the place of others.
    void startFromNets(search::OptimizeOptions &search) const
    {
        if (!mSnapshot.rigid)
            return;
        const int seeds = search.effort.seeds;
        for (SeamedMap &net : netStarts(mGraph, mSnapshot, std::clamp(seeds, 1, 6), mJob.quiet()))
            search.given.push_back(std::move(net));
        if (startsFromNets() && !search.given.empty())
            search.effort.seeds = seeds / 4;
    }

    //! Gives all charts one texel density and measures the map. \returns false when a chart overlaps itself
    bool makeUsable(Candidate &candidate) const
    {
        definite::equalizeDensity(*mSoup, mSnapshot, candidate.map);
        if (!mOptions.allowOverlaps && definite::coversItself(*mSoup, candidate.map))
            return false;
        candidate.measure(*mSoup, mSnapshot);
        return true;
    }

    static Candidate measuresOf(const search::CutState &state)
    {
        Candidate measures;
        measures.bounded = state.distortion;
        measures.distortion =
            state.graph->rigid ? state.map().distortion(*state.graph->soup) : state.distortion;
        measures.seamLength = state.length;
        measures.seamCost = state.cost;
        measures.smallCharts = state.smallParts();
        measures.anchorFaults = state.anchorFaults();
        return measures;
    }

    //! Of a map whose rigid regions have settled: in those, the stiffness of the search counts for nothing.
    bool isWithinBound(const Candidate &found) const { return found.distortion <= mOptions.maxDistortion; }

    bool hasDecidedEdges() const
    {
        const std::vector<PairState> &states = mSnapshot.steering->pairState;
        return std::any_of(states.begin(), states.end(),
                           [](PairState state) { return state != PairState::Free; });
    }

    //! A map made without the user's cuts and joins, then changed to obey them. Joins leave few first cuts to
    //! choose from; this map usually has shorter seams.
    std::optional<SeamedMap> steeredFreeMap(const search::OptimizeOptions &options)
    {
        Snapshot free = mSnapshot;
        free.editSteering().pairState.clear();
        const auto graph = mGraph->steeredBy(free);
        const std::optional<search::OptimizedMap> found = search::optimizeSeams(graph, options);
        if (!found)
            return std::nullopt;
        mIterations += found->iterations;
        const std::optional<search::CutState> state =
            search::resteered(search::CutState::from(graph, found->map, true), mGraph, mJob.quiet());
        return state ? std::optional(state->map()) : std::nullopt;
    }

    //! \returns nothing also when the mesh is too odd for the soup, such as one of very mixed scales
    std::optional<Candidate> bySoup(UnwrapQuality quality)
    {
        UnwrapOptions how = mOptions;
        how.quality = quality;
        std::optional<Candidate> best;
        try {
            best = bestOfSoupChains(mSnapshot, how, mRanking, mJob, mIterations);
        } catch (const std::runtime_error &) {
            return std::nullopt;
        }
        if (best && mSnapshot.placesIslands()) {
            best->anchorFaults =
                search::settleAtAnchors(mGraph, best->map, settleSteps, !mOptions.allowOverlaps, mJob);
            best->measure(*mSoup, mSnapshot);
        }
        return best;
    }

    void keepBetter(std::optional<Candidate> &best, std::optional<Candidate> found) const
    {
        if (!best || (found && mRanking.better(*found, *best)))
            best = std::move(found);
    }

    const std::shared_ptr<const Soup> mSoup;
    const Snapshot &mSnapshot;
    const UnwrapOptions &mOptions;
    const JobContext &mJob;
    Ranking &mRanking;
    const std::shared_ptr<const search::SeamGraph> mGraph; //!< without symmetry
    //! The map before the job, steered, where pins hold islands or given seams stay.
    std::optional<search::CutState> mBefore;
    int mIterations = 0;
};

//! Share of the progress that is for the search on the coarse mesh. A guess that only the progress depends
//! on.
constexpr double coarseShare = 0.55;

//! Share of the stretch allowed that is left for what copies differ by. Chosen by hand.
constexpr double copyTolerance = 1e-4;

//! A carried map as a candidate.
Candidate candidateOf(CarriedMap carried, const Soup &soup, const Snapshot &snapshot)
{
    Candidate candidate;
    candidate.map = std::move(carried.map);
    candidate.lambda = carried.lambda;
    candidate.delta = carried.delta;
    candidate.anchorFaults = carried.anchorFaults;
    candidate.measure(soup, snapshot);
    return candidate;
}

//! Makes the rigid regions of a large mesh keep their shape: those of the coarse mesh are not quite the same.
void settleCarried(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                   const UnwrapOptions &options, const JobContext &job, CarriedMap &carried)
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
    const double mu = carried.lambda / std::max(1 - carried.lambda, smallestShare);
    carried.map = definite::settleRigidRegions(search::SeamGraph::build(soup, preferred), preferred, search,
                                               std::move(carried.map), mu);
    definite::equalizeDensity(*soup, snapshot, carried.map);
}

//! Finds the map of a large mesh by way of a coarser one; nothing when the mesh is not suited or that fails.
std::optional<FoundMap> findLargeMap(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                     const UnwrapOptions &options, const JobContext &job,
                                     const PrepareMap &prepare)
{
    if (!suitsCoarseToFine(snapshot))
        return std::nullopt;
    const auto prepareCarried = [&](MakeCarriedMap make) {
        prepare([=, make = std::move(make)](const JobContext &own) -> std::optional<Candidate> {
            std::optional<CarriedMap> carried = make(own);
            if (!carried)
                return std::nullopt;
            return candidateOf(std::move(*carried), *soup, snapshot);
        });
    };
    CoarseSearch search;
    if (prepare)
        search.relaxing = prepareCarried;
    const JobContext searching = job.part(0, coarseShare);
    search.unwrap = [&](const Snapshot &coarse, const UnwrapOptions &coarseOptions, const CarryOver &carry) {
        const double worst = coarseOptions.maxDistortion + worthCarrying;
        Ranking coarseRanking(coarseOptions, searching);
        coarseRanking.setWatcher([&](const Candidate &best) {
            if (!prepare || best.distortion > worst)
                return;
            const CarriedMap map{best.map, 0, best.lambda, best.delta, best.anchorFaults};
            prepareCarried([=](const JobContext &own) { return carry(map, own); });
        });
        FoundMap found = findMap(coarse, coarseOptions, coarseRanking, searching);
        if (found.best.onlyPatches || job.stopped())
            return std::optional<CarriedMap>();
        return std::optional(CarriedMap{std::move(found.best.map), found.iterations, found.best.lambda,
                                        found.best.delta, found.best.anchorFaults});
    };
    const JobContext refining = job.part(coarseShare, Ranking::optimizingShare, JobStage::Refining);
    std::optional<CarriedMap> carried = mapByCoarse(soup, snapshot, options, search, refining);
    if (!carried)
        return std::nullopt;
    if (!options.lambda)
        settleCarried(soup, snapshot, options, job, *carried);
    FoundMap found;
    found.iterations = carried->iterations;
    if (snapshot.settings.symmetry)
        found.symmetry = 0;
    found.best = candidateOf(std::move(*carried), *soup, snapshot);
    return found;
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
    PrepareMap prepareWhole;
    if (prepare) {
        prepareWhole = [&](ReadyResult::MakeMap make) {
            prepare([whole, make = std::move(make)](const JobContext &context) -> std::optional<Candidate> {
                std::optional<Candidate> made = make(context);
                return made ? whole(std::move(*made), context) : std::nullopt;
            });
        };
        if (!suitsCoarseToFine(parts->snapshot()))
            ranking.setWatcher(
                [&](const Candidate &best) { prepareWhole([best](const JobContext &) { return best; }); });
    }
    FoundMap found = findMap(parts->snapshot(), own, ranking, job, prepareWhole);
    if (snapshot.settings.symmetry)
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

} // namespace

search::OptimizeEffort effortFor(UnwrapQuality quality, int triangles)
{
    search::OptimizeEffort effort = fullEffort(quality);
    const double share = std::clamp(std::sqrt(triangles / fullEffortTriangles), 0.4, 1.0);
    if (quality == UnwrapQuality::Draft)
        effort.seeds = static_cast<int>(std::lround(1 / (share * share)));
    if (quality != UnwrapQuality::Standard)
        return effort;
    const auto more = [share](int count) { return static_cast<int>(std::lround(count / share)); };
    effort.seeds = more(effort.seeds);
    for (search::OptimizeEffort::Round &round : effort.rounds) {
        round.moves = static_cast<int>(share * round.moves);
        round.survivors = more(round.survivors);
    }
    return effort;
}

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
    snapshot.settings.creases = preference::decided(snapshot.settings.creases, *snapshot.mesh);
    std::optional<preference::MeshSymmetry> symmetry;
    if (snapshot.settings.symmetry)
        symmetry = preference::findSymmetry(*snapshot.mesh);
    // Not for symmetric cuts: the coarse mesh would not be symmetric.
    if (!symmetry) {
        if (!options.lambda) {
            if (std::optional<FoundMap> alike = findOneOfEachKind(soup, snapshot, options, job, prepare))
                return std::move(*alike);
        }
        if (std::optional<FoundMap> large = findLargeMap(soup, snapshot, options, job, prepare))
            return std::move(*large);
    }
    FoundMap found;
    if (job.stopped()) {
        if (prepare)
            found.onlyReady = true;
        else
            found.best = patchesOf(given);
        return found;
    }
    if (options.lambda)
        snapshot.settings.flat = FlatMode::Free;
    snapshot = preference::SeamPreference().applied(snapshot, job.threads());
    MapFinder finder(soup, snapshot, options, ranking, job);
    std::optional<Candidate> best = finder.find(symmetry ? &*symmetry : nullptr);
    found.iterations = finder.iterations();
    if (snapshot.rigid && !job.stopped() && (!best || best->distortion > options.maxDistortion)) {
        // The curved parts alone cannot take the stretch that is allowed.
        snapshot.rigid = nullptr;
        MapFinder free(soup, snapshot, options, ranking, job);
        std::optional<Candidate> other = free.find(symmetry ? &*symmetry : nullptr);
        if (other && (!best || ranking.better(*other, *best)))
            best = std::move(other);
        found.iterations += free.iterations();
    }
    found.onlyReady = !best && prepare && job.stopped();
    if (found.onlyReady)
        return found;
    found.best = best ? std::move(*best) : patchesOf(given);
    if (snapshot.settings.symmetry)
        found.symmetry =
            symmetry ? preference::symmetricShare(*snapshot.mesh, *symmetry, found.best.map.cut) : 0;
    return found;
}

} // namespace autocuts::unwrap
