#include "solver/unwrap/mapsearch.h"

#include "solver/base/constant.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/rigidsettling.h"
#include "solver/preference/surfacekind.h"
#include "solver/search/anchoring.h"
#include "solver/search/resteering.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/netstarts.h"
#include "solver/unwrap/soupchains.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Smaller meshes get another effort.
AUTOCUTS_CONSTANT(double, fullEffortTriangles, 2000);

//! Large moves, first cuts and squeezes of fullEffort().
AUTOCUTS_CONSTANT(int, draftMoves, 25);
AUTOCUTS_CONSTANT(int, standardStarts, 10);
AUTOCUTS_CONSTANT(int, standardMoves, 1300);
AUTOCUTS_CONSTANT(int, standardSqueezes, 10);

//! Effort on a mesh of fullEffortTriangles or more. Measured for the whole unwrap, on 14 meshes used in
//! development: seams are .78 times as long as those of OptCuts in standard, in 1/5.8 of its CPU time (on the
//! 11 of more than 3,000 triangles, by way of coarser ones, .77 times in 1/11 of it), and 1.00 times as long
//! in draft, in 1/45 of it. Before there was that way, they were .794 times as long in standard (1/5.4), and
//! .854 times on 18 other meshes.
search::OptimizeEffort fullEffort(UnwrapQuality quality)
{
    switch (quality) {
    case UnwrapQuality::Draft:
        return {1, {{0, 1}, {draftMoves, 1}}, 0, 0.5, 64};
    case UnwrapQuality::Standard:
        return {standardStarts, {{80, 5}, {200, 2}, {standardMoves, 1}}, standardSqueezes};
    case UnwrapQuality::Best:
        return {24, {{100, 12}, {300, 6}, {800, 3}, {2000, 1}}, 10};
    }
    throw std::invalid_argument("unknown quality");
}

//! Least share of the distortion in the energy, for lambda near 1.
constexpr double smallestShare = 1e-9;
constexpr int settleSteps = 20; // Newton steps before hard pins are reached

//! True when a connected part of the surface has more borders or more handles than these.
bool hasPartWithMore(int borders, int handles, const MeshData &mesh)
{
    const CutMesh whole(mesh, CutFlags(mesh.edgePairs.size(), false));
    std::vector<int> loops(whole.chartCount, 0), euler(whole.chartCount, 0);
    for (const std::vector<int> &loop : whole.boundaryLoops())
        ++loops[whole.chart[loop.front() / 3]];
    std::vector<char> seen(whole.uvVertexCount, 0);
    for (std::size_t c = 0; c < whole.uvVertex.size(); ++c) {
        const int chart = whole.chart[c / 3];
        euler[chart] += seen[whole.uvVertex[c]] == 0;
        seen[whole.uvVertex[c]] = 1;
        euler[chart] += c % 3 == 0;
    }
    for (const EdgePair &pair : mesh.edgePairs)
        --euler[whole.chart[pair.triangle[0]]];
    for (const auto &side : mesh.boundarySides)
        --euler[whole.chart[side.triangle]];
    for (int part = 0; part < whole.chartCount; ++part) {
        if (loops[part] > borders || (2 - loops[part] - euler[part]) / 2 > handles)
            return true;
    }
    return false;
}

//! True when a connected part of the surface has several borders, or handles: its first cuts are not few, so
//! that the search also starts from a map of the soup. Draft does so from two handles on. (On rocker-arm,
//! p_torus and human_neutral both qualities find nothing better in that map; draft takes 4 to 9 times the CPU
//! time for it. On chain, standard finds seams that are 2.3 % shorter there, draft longer ones.)
bool isComplicated(const MeshData &mesh, UnwrapQuality quality)
{
    return hasPartWithMore(1, quality == UnwrapQuality::Draft ? 1 : 0, mesh);
}

//! True when a search from few cuts alone would miss good maps.
bool startsFromSoup(const Snapshot &snapshot, UnwrapQuality quality)
{
    return isComplicated(*snapshot.mesh, quality) && !startsFromNets(snapshot);
}

//! Borders or handles of a part from which drafts start from clusters. With fewer (teapot, multiComp,
//! torus_with_holes), they find shorter seams from the soup.
constexpr int manyBorders = 5, manyHandles = 5;

//! Share of the area in rigid regions from which drafts start from nets of these and of clusters, and from
//! which the map of the soup is not taken, in which they bend: it is a start of the search only, and made in
//! a hurry. (In standard, that takes the plate with holes from 31 to 14 CPU seconds for the same seams, and
//! shortens those of truck by 2 %. In drafts, nets take the plate from 10.6 to 1.5 CPU seconds, gear from 5.7
//! to .5.)
constexpr double hardlyRigid = 0.1;
AUTOCUTS_CONSTANT(int, clusterMoves, 300);
//! Effort of a draft that starts from clusters. Measured: 300 moves and 5 squeezes in place of 25 and none
//! shorten the seams of beetle by 34 %, of plane_holes by 6 %, for little time.
const search::OptimizeEffort clusterEffort{1, {{0, 1}, {clusterMoves, 1}}, 5, 0.5, 64};
//! Moves of a draft of a coarse version, or of a model of rigid regions, in place of 25. Measured: seams of
//! 12 fine meshes get .96 times as long, in 1.1 times the CPU time; those of wingnut .81 times, in 1.1 times.
AUTOCUTS_CONSTANT(int, cheapMoves, 200);

//! \returns nothing also when the mesh is too odd for the soup, such as one of very mixed scales
std::optional<Candidate> bySoupChains(const Snapshot &snapshot, const UnwrapOptions &options, bool hurried,
                                      Ranking &ranking, const JobContext &job, int &iterations)
{
    try {
        return bestOfSoupChains(snapshot, options, hurried, ranking, job, iterations);
    } catch (const std::runtime_error &) {
        return std::nullopt;
    }
}

//! What symmetric seams may cost, as a share of what those of the free map cost, where they are not asked
//! for.
constexpr double symmetricPrice = 1.05;
//! Efforts of the two steps in which standard looks for them (best has its own for the second), and the share
//! that the first one may end with. Measured, cost of symmetric seams in one search with all these moves:
//! character .97, spot 1.05, fish 1.06; with half the starts, character has 1.18. CPU time of both steps, as
//! a share of the free search: character .7, spot .5, fish .4.
const search::OptimizeEffort symmetricTrial{10, {{80, 3}, {200, 1}}, 0};
const search::OptimizeEffort symmetricEffort{0, {{1300, 1}}, 10};
constexpr double hopefulTrial = 1.15;
//! Share of the progress at which the first step is done. A guess that only the progress depends on.
constexpr double trialShare = 0.8;

bool isPartlyRigid(const Snapshot &snapshot)
{
    return snapshot.rigid && snapshot.rigid->share >= hardlyRigid;
}

bool hasDecidedEdges(const Snapshot &snapshot)
{
    return std::ranges::any_of(snapshot.steering->pairState,
                               [](PairState state) { return state != PairState::Free; });
}

//! True when neither a map nor steering is given.
bool isUnsteered(const Snapshot &snapshot)
{
    return snapshot.settings.start != StartMode::ExistingUv && snapshot.steering->pins.empty() &&
           snapshot.settings.seams != SeamMode::Keep && !snapshot.placesIslands() &&
           !hasDecidedEdges(snapshot);
}

//! The maps that the seam search starts from.
enum class FirstMaps {
    Usual,
    Clusters,   //!< one of clusters, see search::firstClusters()
    ClusterNets //!< one of clusters and rigid regions, see startFromClusterNets()
};

//! Finds the best map of one unwrap, by the seam search and by the soup.
class MapSearch
{
public:
    //! \param snapshot with the preferences in its weights
    MapSearch(std::shared_ptr<const Soup> soup, const Snapshot &snapshot, const UnwrapOptions &options,
              Ranking &ranking, const JobContext &job)
        : mSoup(std::move(soup)), mSnapshot(snapshot), mOptions(options), mJob(job), mRanking(ranking),
          mGraph(search::SeamGraph::build(mSoup, snapshot))
    {
        if (!snapshot.steering->pins.empty() || snapshot.settings.seams == SeamMode::Keep)
            mBefore = steeredMapBefore(mGraph, snapshot, job);
    }

    int iterations() const { return mIterations; }

    //! Nothing when there is no map.
    std::optional<Candidate> find(const WishedSymmetry &symmetry)
    {
        const bool tries = symmetry.plane && !symmetry.required;
        if (tries)
            mRanking.setPart(0, freeShare);
        std::optional<Candidate> best = search(symmetry.required ? symmetry.plane : nullptr);
        if (tries && best) {
            if (std::optional<Candidate> symmetric = cheapSymmetric(*symmetry.plane, *best))
                return symmetric;
        }
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

    //! The map with symmetric seams, where these hardly cost more than those of a free map.
    std::optional<Candidate> cheapSymmetric(const preference::MeshSymmetry &symmetry, const Candidate &free)
    {
        if (mJob.stopped() || !isWithinBound(free) || free.seamCost <= 0)
            return std::nullopt;
        const auto costsAtMost = [&](const std::optional<Candidate> &found, double share) {
            return !mJob.stopped() && found && isWithinBound(*found) &&
                   found->seamCost <= share * free.seamCost;
        };
        mRanking.setPart(freeShare, trialShare);
        std::optional<Candidate> found = bySearch({}, &symmetry, FirstMaps::Usual, symmetricTrial);
        if (!costsAtMost(found, hopefulTrial))
            return std::nullopt;
        mRanking.setPart(trialShare, 1);
        if (mOptions.quality == UnwrapQuality::Best)
            found = bySearch(found, &symmetry);
        else
            found = bySearch(found, &symmetry, FirstMaps::Usual, symmetricEffort);
        return costsAtMost(found, symmetricPrice) ? found : std::nullopt;
    }

private:
    std::optional<Candidate> search(const preference::MeshSymmetry *symmetry)
    {
        std::optional<Candidate> best;
        if (symmetry)
            best = bySearch({}, symmetry);
        if (mJob.stopped() || (best && isWithinBound(*best)))
            return best;
        if (suitsClusters() || suitsClusterNets()) {
            mFromClusters = bySearch({}, nullptr,
                                     isPartlyRigid(mSnapshot) ? FirstMaps::ClusterNets : FirstMaps::Clusters);
            if (mJob.stopped() || (isDraft() && mFromClusters && isWithinBound(*mFromClusters)))
                return mFromClusters;
        }
        // Only the soup can start from existing UVs.
        if (mOptions.lambda) {
            best = bySoup(mOptions.quality);
        } else if (mSnapshot.settings.start == StartMode::ExistingUv ||
                   startsFromSoup(mSnapshot, mOptions.quality) || (mSnapshot.placesIslands() && !mBefore)) {
            if (std::optional<Candidate> flat = withoutSeams())
                return flat;
            best = bySoup(UnwrapQuality::Draft);
        }
        std::optional<Candidate> searched = bySearch(best, nullptr);
        if (isPartlyRigid(mSnapshot) && searched && isWithinBound(*searched))
            best = std::move(searched); // in the map of the soup, rigid regions bend
        else
            keepBetter(best, std::move(searched));
        if (mFromClusters)
            keepBetter(best, mFromClusters);
        if (mJob.stopped())
            return best;
        if (!best || (!mOptions.lambda && !isWithinBound(*best)))
            keepBetter(best, bySoup(mOptions.quality));
        else if (best->anchorFaults > 0 && mBefore)
            keepBetter(best, bySoup(UnwrapQuality::Draft)); // it tears where pins contradict each other
        return best;
    }

    //! True when a draft starts from clusters. Drafts of small meshes do not: from the soup they find shorter
    //! seams, on torus_with_holes by 21 % in the same time. Nor do those of tangled meshes: on generated ones
    //! with 30 to 40 % of such edges the soup's cuts are two thirds as long, and clusters missed the bound.
    bool suitsClusters() const
    {
        return isDraft() && !mOptions.lambda && isUnsteered(mSnapshot) && !isPartlyRigid(mSnapshot) &&
               mSnapshot.mesh->triangleCount() > fullEffortTriangles && !isTangled(*mSnapshot.mesh) &&
               hasPartWithMore(manyBorders - 1, manyHandles - 1, *mSnapshot.mesh);
    }

    //! True when a draft starts from clusters and rigid regions, and the other qualities also from the map
    //! that a draft makes of these.
    bool suitsClusterNets() const { return !mOptions.lambda && startsFromClusterNets(mSnapshot); }

    bool isDraft() const { return mOptions.quality == UnwrapQuality::Draft; }

    //! The map without seams, when the bound allows it.
    std::optional<Candidate> withoutSeams()
    {
        if (!mGraph->anchors.empty())
            return std::nullopt;
        search::OptimizeOptions options;
        options.maxDistortion = mOptions.maxDistortion;
        options.allowOverlaps = mOptions.allowOverlaps;
        options.job = mJob;
        std::optional<search::OptimizedMap> found = search::flatMap(mGraph, options);
        if (!found)
            return std::nullopt;
        mIterations += found->iterations;
        Candidate candidate;
        candidate.map = std::move(found->map);
        return makeUsable(candidate) ? std::optional(std::move(candidate)) : std::nullopt;
    }

    //! The best map of the seam search. \param other a further map to start from \param effort in place of
    //! that of the quality
    std::optional<Candidate> bySearch(const std::optional<Candidate> &other,
                                      const preference::MeshSymmetry *symmetry,
                                      FirstMaps first = FirstMaps::Usual,
                                      std::optional<search::OptimizeEffort> effort = {})
    {
        search::OptimizeOptions search;
        search.maxDistortion = mOptions.maxDistortion;
        if (mOptions.lambda)
            search.mu = muOf(*mOptions.lambda);
        search.allowOverlaps = mOptions.allowOverlaps;
        search.clusters = first == FirstMaps::Clusters;
        if (effort) {
            search.effort = *effort;
        } else if (first == FirstMaps::Usual) {
            search.effort = effortFor(mOptions.quality, mSnapshot.mesh->triangleCount());
            if (isDraft() && (mOptions.coarse || startsFromNets(mSnapshot)))
                search.effort.rounds.back().moves = cheapMoves;
        } else {
            search.effort = clusterEffort;
        }
        search.seed = mSnapshot.settings.seed;
        search.job = mJob;
        const bool steers = !symmetry && hasDecidedEdges(mSnapshot);
        const bool isBest = mOptions.quality == UnwrapQuality::Best && !effort;
        const int searches = 1 + steers + isBest;
        int begun = 0;
        if (isDraft() || first == FirstMaps::Usual) {
            search.start = [&](int steps) {
                mRanking.setTotal(searches * steps);
                mRanking.stepDone(begun++ * steps);
            };
            search.progress = [&](int steps) { mRanking.stepDone(steps); };
        }
        if (steers) {
            if (std::optional<SeamedMap> free = steeredFreeMap(search))
                search.given.push_back(std::move(*free));
        }
        if (other)
            search.given.push_back(other->map);
        if (other && other->smallCharts > search::CutState::manySmallParts)
            search.effort.seeds = 0; // few cuts do not lay such a surface flat
        if (mBefore)
            search.given.push_back(mBefore->map());
        if (first == FirstMaps::ClusterNets && !startFromClusterNets(mGraph, mSnapshot, search))
            return std::nullopt;
        if (!symmetry && first == FirstMaps::Usual) {
            addNetStarts(mGraph, mSnapshot, mJob.quiet(), search);
            if (mFromClusters)
                search.given.push_back(mFromClusters->map);
        }
        search.improved = [&](const search::CutState &state) {
            mRanking.offer(measuresOf(state), [&] { return state.map(); });
        };
        const auto graph = symmetry ? search::SeamGraph::build(mSoup, mSnapshot, symmetry) : mGraph;
        const auto settled = [&](search::OptimizedMap found) {
            Candidate candidate;
            candidate.anchorFaults = found.anchorFaults;
            candidate.symmetric = symmetry != nullptr;
            candidate.lambda = mOptions.lambda.value_or(found.mu / (1 + found.mu));
            mIterations += found.iterations;
            candidate.map =
                definite::settleRigidRegions(graph, mSnapshot, search, std::move(found.map), found.mu);
            return makeUsable(candidate) ? std::optional(std::move(candidate)) : std::nullopt;
        };
        std::optional<Candidate> best;
        if (isBest) {
            // Begins with the result of the standard quality, so that it is never worse.
            search::OptimizeOptions standard = search;
            standard.effort = effortFor(UnwrapQuality::Standard, mSnapshot.mesh->triangleCount());
            standard.effort.seeds = search.effort.seeds > 0 ? standard.effort.seeds : 0;
            if (std::optional<search::OptimizedMap> found = search::optimizeSeams(graph, standard)) {
                search.given.push_back(found->map);
                best = settled(std::move(*found));
            }
        }
        if (std::optional<search::OptimizedMap> found = search::optimizeSeams(graph, search)) {
            std::optional<Candidate> better = settled(std::move(*found));
            keepBetter(better, std::move(best));
            best = std::move(better);
        }
        return best;
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
        measures.smallCharts = state.smallParts;
        measures.anchorFaults = state.anchorFaults();
        return measures;
    }

    //! Of a map whose rigid regions have settled: in those, the stiffness of the search counts for nothing.
    bool isWithinBound(const Candidate &found) const { return found.distortion <= mOptions.maxDistortion; }

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

    std::optional<Candidate> bySoup(UnwrapQuality quality)
    {
        UnwrapOptions how = mOptions;
        how.quality = quality;
        const bool hurried = mOptions.quality == UnwrapQuality::Draft ||
                             (quality == UnwrapQuality::Draft && isPartlyRigid(mSnapshot));
        std::optional<Candidate> best = bySoupChains(mSnapshot, how, hurried, mRanking, mJob, mIterations);
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
    std::optional<Candidate> mFromClusters; //!< a further map to start from
    int mIterations = 0;
};

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

double muOf(double lambda)
{
    return lambda / std::max(1 - lambda, smallestShare);
}

std::optional<Candidate> searchMap(std::shared_ptr<const Soup> soup, const Snapshot &snapshot,
                                   const UnwrapOptions &options, Ranking &ranking, const JobContext &job,
                                   const WishedSymmetry &symmetry, int &iterations)
{
    MapSearch search(std::move(soup), snapshot, options, ranking, job);
    std::optional<Candidate> best = search.find(symmetry);
    iterations += search.iterations();
    return best;
}

std::optional<Candidate> searchSymmetric(std::shared_ptr<const Soup> soup, const Snapshot &snapshot,
                                         const UnwrapOptions &options, Ranking &ranking,
                                         const JobContext &job, const preference::MeshSymmetry &symmetry,
                                         const Candidate &free, int &iterations)
{
    MapSearch search(std::move(soup), snapshot, options, ranking, job);
    std::optional<Candidate> found = search.cheapSymmetric(symmetry, free);
    iterations += search.iterations();
    return found;
}

bool startsFromClusterNets(const Snapshot &snapshot)
{
    if (!isUnsteered(snapshot) || !isPartlyRigid(snapshot) || startsFromNets(snapshot))
        return false;
    // On a simple surface of 46 parts, a machine, this shortens the seams of drafts and of standard by 22 %.
    // A figure with flat soles gets seams of twice the length from it.
    return isComplicated(*snapshot.mesh, UnwrapQuality::Standard) ||
           preference::isMostlyHard(*snapshot.mesh, snapshot.settings.surface);
}

std::optional<SeamedMap> soupStart(const Snapshot &snapshot, const UnwrapOptions &options,
                                   const JobContext &job)
{
    if (!startsFromSoup(snapshot, UnwrapQuality::Standard))
        return std::nullopt;
    UnwrapOptions how = options;
    how.quality = UnwrapQuality::Draft;
    Ranking ranking(how, job);
    int iterations = 0;
    std::optional<Candidate> found =
        bySoupChains(snapshot, how, isPartlyRigid(snapshot), ranking, job, iterations);
    return found ? std::optional(std::move(found->map)) : std::nullopt;
}

} // namespace autocuts::unwrap
