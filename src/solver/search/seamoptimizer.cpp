#include "solver/search/seamoptimizer.h"

#include "solver/parallel.h"
#include "solver/search/seamsearch.h"
#include "solver/search/seamseeds.h"
#include "solver/tutte.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

constexpr double firstHeat = 1; // edges
constexpr double firstMu = 0.1;
constexpr double smallestMu = 0.005, largestMu = 1;
//! What seams are worth near the bound in most maps, to rank those that are below and above it.
constexpr double usualMu = 0.15, excessMu = 0.07;
constexpr int fewestPaths = 5, mostPaths = 25;
constexpr int squeezeRounds = 10, squeezeMoves = 20;
constexpr int firstRelaxation = 60;     // steps
constexpr double densityReserve = 0.01; // of the distortion above 4, for charts of equal density

//! One map on its way to the bound.
class Run
{
public:
    Run(const std::shared_ptr<const SeamGraph> &graph, const OptimizeOptions &options, CutState state,
        std::uint64_t seed)
        : mOptions(options), mGraph(graph), mState(std::move(state)),
          mSearch(mState, seed, {options.mu.value_or(firstMu), !options.allowOverlaps, options.stop}),
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
            if (mSearch.relaxAll(10) < 1e-4 || mSearch.stopped())
                break;
        }
        mBest = mState;
        mBestScore = score();
        for (int i = 0; i < 3 && !mSearch.stopped(); ++i) {
            mSearch.polish(1);
            mSearch.relaxAll(3);
            adaptMu(0.4);
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
            if (i % interval == interval - 1) {
                adaptMu(0.2);
                if (i % (5 * interval) == 5 * interval - 1) {
                    mSearch.relaxAll(2);
                    mSearch.polish(1);
                    mState.updateEnergy();
                }
                keepBest();
                report(interval);
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
        for (int i = 0; i < 40 && mState.energy > bound() && !mSearch.stopped(); ++i) {
            mSearch.setMu(std::max(smallestMu, mSearch.mu() * (i < 10 ? 0.93 : 0.8)));
            mSearch.polish(1);
            mSearch.relaxAll(3);
        }
        keepBest();
        restoreBest();
        mSearch.relaxAll(10);
        if (mState.energy > bound())
            return;
        // What room is left goes to the seams that cost least.
        mSearch.setCeiling(bound());
        mSearch.setHeat(0);
        for (int i = 0; i < squeezeRounds && !mSearch.stopped(); ++i) {
            mSearch.setMu(mSearch.mu() * 1.15);
            mSearch.polish(1);
            for (int k = 0; k < squeezeMoves; ++k)
                mSearch.tryLargeMove();
            if (mSearch.relaxAll(2) > 0)
                keepBest();
        }
        keepBest();
        restoreBest();
    }

    //! True when nothing is cut but what has to be, within the bound.
    bool needsNoSeams() const
    {
        double forced = 0;
        for (std::size_t e = 0; e < mBest.cut.size(); ++e)
            forced += mGraph->rule[e] == SeamGraph::Rule::AlwaysCut ? mGraph->cost[e] : 0;
        return fits() && mBest.cost <= forced;
    }

    CutState &best() { return mBest; }
    double bestScore() const { return mBestScore; }
    SeamSearch &searcher() { return mSearch; }
    bool fits() const { return mOptions.mu || mBest.energy <= bound(); }

private:
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

std::optional<CutState> firstMap(const std::shared_ptr<const SeamGraph> &graph,
                                 const OptimizeOptions &options, int number)
{
    // Numbers of paths spread evenly in the logarithm, whatever the number of seeds.
    const double place = std::fmod(0.5 + 0.6180339887498949 * number, 1.0);
    SeedOptions seed;
    seed.paths = static_cast<int>(std::round(fewestPaths * std::pow(double(mostPaths) / fewestPaths, place)));
    // A map without any cut where there are borders: flat meshes need no more.
    const std::vector<bool> &border = graph->border;
    if (number == 0 && std::find(border.begin(), border.end(), true) != border.end())
        seed.paths = 0;
    seed.joinBorders = number % 2 == 1;
    seed.seed = options.seed * 1000 + static_cast<std::uint64_t>(number);
    seed.stop = options.stop;
    const std::vector<char> cut = fewCuts(*graph, seed);
    SeamedMap map;
    map.cut.assign(cut.begin(), cut.end());
    map.x = tutteEmbedding(*graph->soup, CutMesh(*graph->soup->mesh, map.cut));
    if (!map.validate(*graph->soup).empty())
        return std::nullopt;
    return usable(CutState::from(graph, map), options);
}

} // namespace

std::optional<OptimizedMap> optimizeSeams(const std::shared_ptr<const SeamGraph> &graph,
                                          const OptimizeOptions &options)
{
    const OptimizeEffort &effort = options.effort;
    if (options.start)
        options.start(effort.seeds * effort.seedMoves + effort.finalists * effort.moves);
    int iterations = 0;
    const int given = static_cast<int>(options.given.size());
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
    begin(0);
    if (runs[0] && runs[0]->needsNoSeams())
        return OptimizedMap{runs[0]->best().map(), 0, runs[0]->searcher().steps()};
    parallelFor(effort.seeds + given, options.threads, [&](int i) {
        if (i > 0)
            begin(i);
        if (runs[i])
            runs[i]->search(effort.seedMoves);
    });
    std::erase_if(runs, [](const auto &run) { return !run; });
    if (runs.empty())
        return std::nullopt;
    std::stable_sort(runs.begin(), runs.end(),
                     [](const auto &a, const auto &b) { return a->expectedCost() < b->expectedCost(); });
    const int finalists = std::min<int>(effort.finalists, static_cast<int>(runs.size()));
    for (std::size_t i = finalists; i < runs.size(); ++i)
        iterations += runs[i]->searcher().steps();
    runs.resize(finalists);
    parallelFor(finalists, options.threads, [&](int i) {
        runs[i]->search(effort.moves);
        runs[i]->finish();
    });
    for (const auto &run : runs)
        iterations += run->searcher().steps();
    const auto better = [](const std::unique_ptr<Run> &a, const std::unique_ptr<Run> &b) {
        return a->fits() != b->fits() ? a->fits() : a->bestScore() < b->bestScore();
    };
    Run &best = **std::min_element(runs.begin(), runs.end(), better);
    return OptimizedMap{best.best().map(), best.searcher().mu(), iterations};
}

} // namespace autocuts
