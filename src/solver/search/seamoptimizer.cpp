#include "solver/search/seamoptimizer.h"

#include "solver/base/parallel.h"
#include "solver/search/seamsearch.h"
#include "solver/search/seamseeds.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

namespace {

constexpr double firstHeat = 1; // edges
constexpr double firstMu = 0.1;
constexpr double smallestMu = 0.005, largestMu = 1;
//! What seams are worth near the bound in most maps, to rank those that are below and above it.
constexpr double usualMu = 0.15, excessMu = 0.07;
//! Where the first cuts stop. Round shapes do best with few, limbs get theirs in any case.
constexpr double leastShrinkage = 0.7, mostShrinkage = 5;
constexpr double hopelessExcess = 1; // of the first map above the bound, for a flat one
constexpr double leastMu = 1e-5;
constexpr int boundRounds = 50;
constexpr int squeezeMoves = 20;
constexpr int firstTries = 3;
constexpr int firstRelaxation = 60;     // steps
constexpr double firstTolerance = 1e-2; // of the energy, in ten steps
constexpr int firstPolishes = 4;
constexpr double fastFall = 0.25;       // of the energy above the bound, in one polish
constexpr double densityReserve = 0.01; // of the distortion above 4, for charts of equal density

//! One map on its way to the bound.
class Run
{
public:
    Run(const std::shared_ptr<const SeamGraph> &graph, const OptimizeOptions &options, CutState state,
        std::uint64_t seed)
        : mOptions(options), mGraph(graph), mState(std::move(state)),
          mSearch(mState, seed, {options.mu.value_or(firstMu), !options.allowOverlaps, options.job}),
          mBest(mState)
    {
        mBestScore = score();
    }

    //! Seam cost that the map would have at the bound, or its objective where there is none.
    double score() const
    {
        if (mOptions.mu)
            return mState.objective(*mOptions.mu);
        return mState.cost + std::max(0.0, mState.energy - bound()) / excessMu;
    }
    double expectedCost() const
    {
        if (mOptions.mu)
            return score();
        const double over = mState.energy - bound();
        return mState.cost + over / (over > 0 ? excessMu : usualMu);
    }

    void start()
    {
        // Even in a hurry: before this the map is badly distorted.
        for (int i = 0; i < firstRelaxation / 10; ++i) {
            if (mSearch.relaxAll(10) < firstTolerance || mSearch.stopped())
                break;
        }
        mSearch.absorbSmallCharts();
        mBest = mState;
        mBestScore = score();
        for (int i = 0; i < firstPolishes && !mSearch.stopped(); ++i) {
            const double before = mState.energy;
            mSearch.polish(1);
            mSearch.relaxAll(3);
            // Cheap seams would spoil a map that is still on its way.
            if (before - mState.energy < fastFall * (mState.energy - bound()) || mState.energy < bound())
                adaptMu(0.4);
            report(0);
        }
        keepBest();
        report(0);
    }

    void search(int moves)
    {
        constexpr int interval = 20;
        for (int i = 0; i < moves && !mSearch.stopped(); ++i) {
            mSearch.setHeat(firstHeat * (1 - double(i) / moves));
            mSearch.tryLargeMove();
            report(1);
            if (i % interval == interval - 1) {
                adaptMu(0.2);
                if (i % (5 * interval) == 5 * interval - 1) {
                    mSearch.relaxAll(2);
                    mSearch.polish(1);
                    mState.updateEnergy();
                }
                keepBest();
            }
        }
    }

    //! Meets the bound: more seams until it holds, then as few as it allows.
    void finish()
    {
        if (mOptions.mu || mSearch.stopped()) {
            restoreBest();
            return;
        }
        mSearch.absorbSmallCharts();
        meetBound();
        keepBest();
        restoreBest();
        mSearch.relaxAll(10);
        if (mState.energy > bound())
            return;
        // What room is left goes to the seams that cost least.
        mSearch.setCeiling(bound());
        mSearch.setHeat(0);
        for (int i = 0; i < mOptions.effort.squeezes && !mSearch.stopped(); ++i) {
            mSearch.setMu(mSearch.mu() * std::pow(4.0, 1.0 / mOptions.effort.squeezes));
            mSearch.polish(1);
            for (int k = 0; k < squeezeMoves; ++k)
                mSearch.tryLargeMove();
            if (mSearch.relaxAll(2) > 0)
                keepBest();
            report(0);
        }
        keepBest();
        restoreBest();
    }

    CutState &best() { return mBest; }
    double bestScore() const { return mBestScore; }
    SeamSearch &searcher() { return mSearch; }
    bool fits() const { return mOptions.mu || mBest.energy <= bound(); }

private:
    //! Makes seams cheaper and cheaper until the bound holds.
    void meetBound()
    {
        double mu = mSearch.mu();
        mSearch.setHeat(0);
        for (int i = 0; i < boundRounds && mState.energy > bound() && !mSearch.stopped(); ++i) {
            mu = std::max(leastMu, mu * mOptions.effort.boundFall);
            mSearch.setMu(mu);
            mSearch.polish(1);
            for (int k = 0; k < mOptions.effort.boundMoves; ++k)
                mSearch.tryLargeMove();
            mSearch.relaxAll(3);
            report(0);
        }
    }

    void report(int steps) const
    {
        if (mOptions.progress)
            mOptions.progress(steps, mBest.energy, mBest.length);
    }

    double bound() const
    {
        const double reserve = mState.chartCount() > 1 ? densityReserve : 1e-4;
        return mOptions.maxDistortion - reserve * (mOptions.maxDistortion - 4);
    }

    //! Seams get cheaper at once where the energy is above the bound and dearer where it is below; the
    //! balance itself follows slowly.
    void adaptMu(double power)
    {
        if (mOptions.mu)
            return;
        const double room = mOptions.maxDistortion - 4;
        const double over = (mState.energy - bound()) / room;
        mBalance *= std::exp(-power * std::clamp(over, -0.5, 0.5));
        mBalance = std::clamp(mBalance, smallestMu, largestMu);
        mSearch.setMu(mBalance / (1 + std::clamp(2 * over, -0.6, 5.0)));
    }

    void keepBest()
    {
        const double now = score();
        const bool nowFits = mOptions.mu || mState.energy <= bound();
        const bool bestFits = mOptions.mu || mBest.energy <= bound();
        if (nowFits != bestFits ? nowFits : now < mBestScore) {
            mBest = mState;
            mBestScore = now;
        }
    }

    void restoreBest() { mSearch.restore(mBest); }

    const OptimizeOptions &mOptions;
    std::shared_ptr<const SeamGraph> mGraph;
    CutState mState;
    SeamSearch mSearch;
    CutState mBest;
    double mBestScore = 0;
    double mBalance = firstMu;
};

//! A start, unless it covers itself where that is not allowed.
std::optional<CutState> usable(CutState state, const OptimizeOptions &options)
{
    if (!options.allowOverlaps && (!state.loopsAreInOrder() || state.boundariesOverlap()))
        return std::nullopt;
    return state;
}

//! The map without any cut, for surfaces that need none; nothing when that is not so.
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
    for (int i = 0; i < firstRelaxation / 10; ++i) {
        const double gained = trial.relaxAll(10, !options.allowOverlaps);
        if (state->energy > options.maxDistortion + hopelessExcess)
            return std::nullopt;
        if (gained < 1e-6)
            break;
    }
    if (state->energy > options.maxDistortion)
        return std::nullopt;
    return OptimizedMap{state->map(), 0, trial.patch().steps()};
}

//! Ends the runs that promise least; returns the Newton steps that they have taken.
int keepMostPromising(std::vector<std::unique_ptr<Run>> &runs, int count)
{
    std::stable_sort(runs.begin(), runs.end(),
                     [](const auto &a, const auto &b) { return a->expectedCost() < b->expectedCost(); });
    int iterations = 0;
    while (static_cast<int>(runs.size()) > count) {
        iterations += runs.back()->searcher().steps();
        runs.pop_back();
    }
    return iterations;
}

//! \param number of the seed; each gives another map, and some give none
std::optional<CutState> tryFirstMap(const std::shared_ptr<const SeamGraph> &graph,
                                    const OptimizeOptions &options, int number)
{
    // From many paths to few, spread evenly in the logarithm whatever the number of seeds.
    const double place = std::fmod(0.1 + 0.6180339887498949 * number, 1.0);
    SeedOptions seed;
    seed.shrinkage = leastShrinkage * std::pow(mostShrinkage / leastShrinkage, place);
    seed.joinBorders = number % 2 == 1;
    seed.seed = options.seed * 1000 + static_cast<std::uint64_t>(number);
    seed.job = options.job;
    const std::vector<char> cut = fewCuts(*graph, seed);
    SeamedMap map;
    map.cut.assign(cut.begin(), cut.end());
    map.x = tutteEmbedding(*graph->soup, CutMesh(*graph->soup->mesh, map.cut));
    if (!map.validate(*graph->soup).empty())
        return std::nullopt;
    return usable(CutState::from(graph, map), options);
}

std::optional<CutState> firstMap(const std::shared_ptr<const SeamGraph> &graph,
                                 const OptimizeOptions &options, int number)
{
    std::optional<CutState> state;
    for (int i = 0; i < firstTries && !state; ++i)
        state = tryFirstMap(graph, options, number + i * options.effort.seeds);
    return state;
}

} // namespace

std::optional<OptimizedMap> optimizeSeams(const std::shared_ptr<const SeamGraph> &graph,
                                          const OptimizeOptions &options)
{
    if (!options.mu) {
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
    int iterations = 0;
    std::vector<std::unique_ptr<Run>> runs(effort.seeds + given);
    const auto begin = [&](int i) {
        std::optional<CutState> state =
            i < effort.seeds ? firstMap(graph, options, i)
                             : usable(CutState::from(graph, options.given[i - effort.seeds]), options);
        if (state) {
            runs[i] = std::make_unique<Run>(graph, options, std::move(*state), options.seed * 1000 + i);
            runs[i]->start();
        }
    };
    for (std::size_t round = 0; round < effort.rounds.size(); ++round) {
        if (round > 0)
            iterations += keepMostPromising(runs, effort.rounds[round - 1].survivors);
        const bool last = round + 1 == effort.rounds.size();
        parallelFor(static_cast<int>(runs.size()), options.job.threads(), [&](int i) {
            if (round == 0)
                begin(i);
            if (!runs[i])
                return;
            runs[i]->search(effort.rounds[round].moves);
            if (last)
                runs[i]->finish();
        });
        std::erase_if(runs, [](const auto &run) { return !run; });
        if (runs.empty())
            return std::nullopt;
    }
    for (const auto &run : runs)
        iterations += run->searcher().steps();
    const auto better = [](const std::unique_ptr<Run> &a, const std::unique_ptr<Run> &b) {
        return a->fits() != b->fits() ? a->fits() : a->bestScore() < b->bestScore();
    };
    Run &best = **std::min_element(runs.begin(), runs.end(), better);
    return OptimizedMap{best.best().map(), best.searcher().mu(), iterations};
}

} // namespace autocuts::search
