#include "solver/search/seamoptimizer.h"

#include "model/plain/parallel.h"
#include "solver/base/constant.h"
#include "solver/search/firstclusters.h"
#include "solver/search/seamseeds.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::search {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Range of SeedOptions::shrinkage over the first cuts. Large values give few cuts, which suits round shapes
//! best; long limbs shrink so much that they get a cut at any value.
constexpr double leastShrinkage = 0.7, mostShrinkage = 5;
//! The map without cuts is given up when its energy is this far above the bound after twenty Newton steps.
//! (That of alligator, which is flat, is at 204 after ten and at 4 after twenty.)
AUTOCUTS_CONSTANT(double, hopelessExcess, 1);
constexpr int tensOfSteps = 2;
//! Other first cuts that are tried in place of one whose map folds or overlaps; a long limb may do so for
//! single seeds.
constexpr int firstTries = 3;
//! The first maps of all are told while they have this share of the distortion told last, at most.
constexpr double worthTelling = 0.7;
//! A run is not searched when its first map is expected to cost more than this many times what the most
//! promising one does, counted as leastCost or more. Measured in standard on 27 meshes: runs of up to 22
//! times the cost became the best. The maps stay the same, and gear and truck take half of the time: the
//! dearest first maps are those in which the search opens most seams.
AUTOCUTS_CONSTANT(double, hopelessTimes, 50);
//! The same for a run that has been searched. Measured in standard on 32 meshes: all maps stay the same but
//! for that of a machine of 46 parts, where such runs took more than half of the time.
AUTOCUTS_CONSTANT(double, hopelessLater, 5);
constexpr double leastCost = 1;
//! Runs that were given up and are taken to the bound after all, at most; and the share of the best map's
//! score below which their expected cost has to be.
constexpr int mostChances = 3;
AUTOCUTS_CONSTANT(double, worthChance, 0.95);

//! The state itself; nothing when charts overlap themselves and that is not allowed, or when stopped.
std::optional<CutState> usable(CutState state, const OptimizeOptions &options)
{
    if (!options.allowOverlaps && !state.isFreeOfOverlaps({}, options.job))
        return std::nullopt;
    return state;
}

using Runs = std::vector<std::unique_ptr<SeamRun>>;

bool isMorePromising(const SeamRun &a, const SeamRun &b)
{
    const int faultsOfA = a.anchorFaults(), faultsOfB = b.anchorFaults();
    return faultsOfA != faultsOfB ? faultsOfA < faultsOfB : a.expectedCost() < b.expectedCost();
}

bool hasBetterMap(const SeamRun &a, const SeamRun &b)
{
    const int faultsOfA = a.anchorFaults(), faultsOfB = b.anchorFaults();
    if (faultsOfA != faultsOfB)
        return faultsOfA < faultsOfB;
    return a.fits() != b.fits() ? a.fits() : a.bestScore() < b.bestScore();
}

void sortByPromise(Runs &runs)
{
    std::stable_sort(runs.begin(), runs.end(),
                     [](const auto &a, const auto &b) { return isMorePromising(*a, *b); });
}

//! Ends the runs that are expected to cost more than `times` what the most promising one does. \pre they have
//! been relaxed
void dropHopeless(Runs &runs, double times)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto &run : runs) {
        if (run)
            least = std::min(least, run->expectedCost());
    }
    if (least == std::numeric_limits<double>::infinity())
        return;
    for (auto &run : runs) {
        // Also when it is not a number.
        if (run && !(run->expectedCost() <= times * std::max(leastCost, least)))
            run.reset();
    }
}

//! Moves the least promising runs to the end of `retired` until `count` are left.
void keepMostPromising(Runs &runs, int count, Runs &retired)
{
    sortByPromise(runs);
    while (static_cast<int>(runs.size()) > count) {
        retired.push_back(std::move(runs.back()));
        runs.pop_back();
    }
}

//! The best map of all may come from a run that was given up: those that promise a better map than the best
//! one has turned out to be are taken to the bound as well. \returns the run with the best map
const SeamRun &bestOfAll(const Runs &runs, Runs &retired, int threads)
{
    const auto better = [](const auto &a, const auto &b) { return hasBetterMap(*a, *b); };
    const SeamRun *best = std::min_element(runs.begin(), runs.end(), better)->get();
    sortByPromise(retired);
    int chances = mostChances;
    for (const auto &run : retired) {
        const bool unlikeBest = run->anchorFaults() < best->anchorFaults() || !best->fits();
        if (unlikeBest || run->expectedCost() < worthChance * best->bestScore()) {
            if (chances-- > 0) {
                run->useThreads(threads);
                run->takeToBound(unlikeBest ? std::numeric_limits<double>::infinity() : best->bestScore());
            }
        }
        if (hasBetterMap(*run, *best))
            best = run.get();
    }
    return *best;
}

//! \returns nothing when the map has flipped triangles, or overlaps that are not allowed, or when stopped
std::optional<CutState> mapOfSeed(const std::shared_ptr<const SeamGraph> &graph,
                                  const OptimizeOptions &options, const SeedOptions &seed)
{
    const std::vector<char> cut = fewCuts(*graph, seed);
    if (seed.job.stopped())
        return std::nullopt;
    SeamedMap map;
    map.cut.assign(cut.begin(), cut.end());
    map.x = tutteEmbedding(*graph->soup, CutMesh(*graph->soup->mesh, map.cut));
    if (!map.validate(*graph->soup).empty())
        return std::nullopt;
    return usable(CutState::from(graph, map), options);
}

//! First cuts and their map. \param number every number gives other cuts
std::optional<CutState> tryFirstMap(const std::shared_ptr<const SeamGraph> &graph,
                                    const OptimizeOptions &options, int number)
{
    // Multiples of the golden ratio spread the numbers evenly over the logarithmic range, however many seeds
    // there are.
    const double place = std::fmod(0.1 + 0.6180339887498949 * number, 1.0);
    SeedOptions seed;
    seed.shrinkage = leastShrinkage * std::pow(mostShrinkage / leastShrinkage, place);
    seed.joinBorders = number % 2 == 1;
    seed.seed = options.seed * 1000 + static_cast<std::uint64_t>(number);
    seed.job = options.job;
    double told = std::numeric_limits<double>::infinity();
    if (number == 0 && options.improved && graph->anchors.empty()) {
        seed.embedded = [&](const SeamedMap &map) {
            const double distortion = map.distortion(*graph->soup);
            if (!(distortion < worthTelling * told) || !map.validate(*graph->soup).empty())
                return;
            if (const std::optional<CutState> state = usable(CutState::from(graph, map), options)) {
                options.improved(*state);
                told = distortion;
            }
        };
    }
    return mapOfSeed(graph, options, seed);
}

} // namespace

std::optional<OptimizedMap> flatMap(const std::shared_ptr<const SeamGraph> &graph,
                                    const OptimizeOptions &options)
{
    const MeshData &mesh = *graph->soup->mesh;
    SeamedMap map;
    for (const SeamGraph::Rule rule : graph->rule)
        map.cut.push_back(rule == SeamGraph::Rule::AlwaysCut);
    const CutMesh whole(mesh, map.cut);
    std::vector<bool> open(whole.chartCount, false);
    for (int side = 0; side < mesh.soupCornerCount(); ++side) {
        if (whole.neighbour[side] < 0)
            open[whole.chart[side / 3]] = true;
    }
    if (std::find(open.begin(), open.end(), false) != open.end())
        return std::nullopt;
    map.x = tutteEmbedding(*graph->soup, whole);
    if (!map.validate(*graph->soup).empty())
        return std::nullopt;
    std::optional<CutState> state = usable(CutState::from(graph, map), options);
    if (!state)
        return std::nullopt;
    SeamTrial trial(*state);
    for (int i = 1; i <= SeamRun::firstRelaxation / 10; ++i) {
        const double gained = trial.relaxAll(10, !options.allowOverlaps, options.job.quiet());
        if (i >= tensOfSteps && state->distortion > options.maxDistortion + hopelessExcess)
            return std::nullopt;
        if (gained < 1e-6 || options.job.stopped())
            break;
    }
    options.job.addWork(trial.patch().work());
    if (state->distortion > options.maxDistortion)
        return std::nullopt;
    return OptimizedMap{state->map(), 0, trial.patch().steps(), {}};
}

std::optional<CutState> firstMap(const std::shared_ptr<const SeamGraph> &graph,
                                 const OptimizeOptions &options, int number)
{
    if (options.clusters)
        return firstClusters(graph, options);
    std::optional<CutState> state;
    for (int i = 0; i < firstTries && !state; ++i)
        state = tryFirstMap(graph, options, number + i * options.effort.seeds);
    return state;
}

std::optional<OptimizedMap> optimizeSeams(const std::shared_ptr<const SeamGraph> &graph,
                                          const OptimizeOptions &options)
{
    if (!options.mu && graph->anchors.empty()) {
        if (std::optional<OptimizedMap> flat = flatMap(graph, options))
            return flat;
    }
    const OptimizeEffort &effort = options.effort;
    const int given = static_cast<int>(options.given.size());
    if (options.start) {
        int steps = 0, running = effort.seeds + given;
        for (const OptimizeEffort::Round &round : effort.rounds) {
            steps += running * round.moves;
            running = std::min(running, round.survivors);
        }
        options.start(steps);
    }
    Runs runs(effort.seeds + given), retired;
    const auto begin = [&](int i) {
        if (options.job.stopped())
            return;
        std::optional<CutState> state =
            i < effort.seeds ? firstMap(graph, options, i)
                             : usable(CutState::from(graph, options.given[i - effort.seeds], true), options);
        if (state) {
            runs[i] = std::make_unique<SeamRun>(options, std::move(*state), options.seed * 1000 + i);
            runs[i]->relax();
        }
    };
    parallelFor(static_cast<int>(runs.size()), options.job.threads(), begin);
    int planned = static_cast<int>(runs.size());
    for (std::size_t round = 0; round < effort.rounds.size(); ++round) {
        if (round > 0) {
            keepMostPromising(runs, effort.rounds[round - 1].survivors, retired);
            planned = std::min(planned, effort.rounds[round - 1].survivors);
        }
        // The cost of maps on pins is only known when they lie there.
        if (graph->anchors.empty())
            dropHopeless(runs, round == 0 ? hopelessTimes : hopelessLater);
        if (options.progress) {
            const auto left = std::ranges::count_if(runs, [](const auto &run) { return run != nullptr; });
            options.progress((planned - static_cast<int>(left)) * effort.rounds[round].moves);
        }
        const bool last = round + 1 == effort.rounds.size();
        const auto searched = std::ranges::count_if(runs, [](const auto &run) { return run != nullptr; });
        const int threadsOfEach = options.job.threads() / std::max(1, static_cast<int>(searched));
        parallelFor(static_cast<int>(runs.size()), options.job.threads(), [&](int i) {
            if (!runs[i])
                return;
            runs[i]->useThreads(std::max(1, threadsOfEach));
            if (round == 0)
                runs[i]->start();
            runs[i]->search(effort.rounds[round].moves);
            if (last)
                runs[i]->takeToBound();
        });
        std::erase_if(runs, [](const auto &run) { return !run; });
        if (runs.empty())
            return std::nullopt;
    }
    const SeamRun &best = bestOfAll(runs, retired, options.job.threads());
    int iterations = 0;
    for (const Runs *all : {&runs, &retired}) {
        for (const auto &run : *all)
            iterations += run->steps();
    }
    return OptimizedMap{best.best().map(), best.mu(), iterations, best.best().anchorFaults()};
}

} // namespace autocuts::search
