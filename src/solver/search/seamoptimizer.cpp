#include "solver/search/seamoptimizer.h"

#include "solver/base/parallel.h"
#include "solver/search/seamsearch.h"
#include "solver/search/seamseeds.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

namespace {

// Mu is the energy that one unit of seam cost is worth. In the prototype its value at a bound of 4.1 ended
// between 0.05 and 0.25, depending on the mesh. Where no other source is named, a number below was chosen by
// hand and its effect has not been measured.

//! Heat of the annealing at its start: the mean worsening that a large move is allowed, in mean edge lengths
//! of seam.
constexpr double firstHeat = 1;
constexpr double firstMu = 0.1;
constexpr double smallestMu = 0.005, largestMu = 1;
//! Typical mu near the bound, to compare maps at different distortion: usualMu converts energy below the
//! bound into seam cost, excessMu energy above it.
constexpr double usualMu = 0.15, excessMu = 0.07;
//! Range of SeedOptions::shrinkage over the first cuts. The prototype used 0.7 alone. Large values give few
//! cuts, which suits round shapes best; long limbs shrink so much that they get a cut at any value.
constexpr double leastShrinkage = 0.7, mostShrinkage = 5;
//! The map without cuts is given up when its energy is this far above the bound after ten Newton steps.
constexpr double hopelessExcess = 1;
constexpr double leastMu = 1e-5;
constexpr int boundRounds = 50;  // in which mu falls until the bound holds, at most
constexpr int squeezeMoves = 20; // large moves per squeeze
//! Other first cuts that are tried in place of one whose map folds or overlaps; a long limb may do so for
//! single seeds.
constexpr int firstTries = 3;
constexpr int firstRelaxation = 60;     // Newton steps on a first map, at most
constexpr double firstTolerance = 1e-2; // energy gained in ten steps below which the relaxation ends
constexpr int firstPolishes = 4;
//! While a polish lowers the energy above the bound by more than this share, mu stays. Without this rule,
//! round shapes that start from one path ended with 5 to 10 % longer seams.
constexpr double fastFall = 0.25;
//! Seam cost that a fault at the anchors counts as: far more than the seams of any map.
constexpr double anchorFaultCost = 1000;
//! Share of (bound - 4) that is kept free in maps of several charts, because giving the charts one texel
//! density afterwards costs some distortion.
constexpr double densityReserve = 0.01;

//! The search on one map, from its first cuts to the bound.
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

    //! What keepBest() minimises: the seam cost, plus a penalty for energy above the bound. With a given mu,
    //! the objective.
    double score() const
    {
        if (mOptions.mu)
            return mState.objective(*mOptions.mu) + anchorFaultCost * mState.anchorFaults();
        return mState.cost + std::max(0.0, mState.distortion - bound()) / excessMu + steeringCost();
    }
    //! Seam cost that the map is expected to have once it is at the bound; ranks the runs after a round.
    double expectedCost() const
    {
        if (mOptions.mu)
            return score();
        const double over = mState.distortion - bound();
        return mState.cost + over / (over > 0 ? excessMu : usualMu) + steeringCost();
    }

    //! Relaxes the first map, joins small charts and polishes the seams.
    void start()
    {
        // What lies on its pins already must not be pulled off them.
        if (mState.anchored)
            mSearch.anchor();
        // Done even when stopped: without at least ten steps the map is badly distorted.
        for (int i = 0; i < firstRelaxation / 10; ++i) {
            if (mSearch.relaxAll(10) < firstTolerance || mSearch.stopped())
                break;
        }
        mSearch.anchor();
        mSearch.absorbSmallCharts();
        mBest = mState;
        mBestScore = score();
        for (int i = 0; i < firstPolishes && !mSearch.stopped(); ++i) {
            const double before = mState.distortion;
            mSearch.polish(1);
            mSearch.relaxAll(3);
            // Lowering mu while the energy still falls fast would open needless seams.
            if (before - mState.distortion < fastFall * (mState.distortion - bound()) ||
                mState.distortion < bound())
                adaptMu(0.4);
            report(0);
        }
        keepBest();
        report(0);
    }

    //! Tries large moves while the heat falls to zero. Mu is adapted after every 20 moves (the prototype: 8).
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
        mSearch.anchor();
        keepBest();
    }

    //! Opens seams until the bound holds, then shortens them as far as the bound allows. Ends with the best
    //! map of the run.
    void takeToBound()
    {
        if (mOptions.mu || mSearch.stopped()) {
            restoreBest();
            return;
        }
        mSearch.absorbSmallCharts();
        meetBound();
        mSearch.anchor();
        keepBest();
        restoreBest();
        mSearch.relaxAll(10);
        if (mState.distortion > bound())
            return;
        // Spend what is left of the bound: rising mu removes the seams that raise the energy least per
        // length.
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
    int anchorFaults() const { return mBest.anchorFaults(); }
    SeamSearch &searcher() { return mSearch; }
    bool fits() const { return mOptions.mu || mBest.distortion <= bound(); }

private:
    //! Lowers mu step by step until the bound holds.
    void meetBound()
    {
        double mu = mSearch.mu();
        mSearch.setHeat(0);
        for (int i = 0; i < boundRounds && mState.distortion > bound() && !mSearch.stopped(); ++i) {
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
            mOptions.progress(steps, mBest.distortion, mBest.length);
    }

    //! What pins and rectangles cost, in seam cost.
    double steeringCost() const
    {
        return (mState.energy - mState.distortion) / usualMu + anchorFaultCost * mState.anchorFaults();
    }

    //! Bound on the energy less a small reserve.
    double bound() const
    {
        const double reserve = mState.chartCount() > 1 ? densityReserve : 1e-4;
        return mOptions.maxDistortion - reserve * (mOptions.maxDistortion - 4);
    }

    //! Adapts mu to the distance from the bound: mu falls at once when the energy is above the bound and
    //! rises when it is below, while the balance that it is derived from follows slowly.
    //! \param power how fast the balance follows
    void adaptMu(double power)
    {
        if (mOptions.mu)
            return;
        const double room = mOptions.maxDistortion - 4;
        const double over = (mState.distortion - bound()) / room;
        mBalance *= std::exp(-power * std::clamp(over, -0.5, 0.5));
        mBalance = std::clamp(mBalance, smallestMu, largestMu);
        mSearch.setMu(mBalance / (1 + std::clamp(2 * over, -0.6, 5.0)));
    }

    void keepBest()
    {
        const double now = score();
        const int nowFaults = mState.anchorFaults(), bestFaults = mBest.anchorFaults();
        const bool nowFits = mOptions.mu || mState.distortion <= bound();
        const bool bestFits = mOptions.mu || mBest.distortion <= bound();
        if (nowFaults != bestFaults ? nowFaults < bestFaults
            : nowFits != bestFits   ? nowFits
                                    : now < mBestScore) {
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

//! The state itself; nothing when charts overlap themselves and that is not allowed.
std::optional<CutState> usable(CutState state, const OptimizeOptions &options)
{
    if (!options.allowOverlaps && (!state.loopsAreInOrder() || state.boundariesOverlap()))
        return std::nullopt;
    return state;
}

//! The map with no other cuts than the user's, relaxed; nothing when a chart is closed or the map misses the
//! bound.
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
        if (state->distortion > options.maxDistortion + hopelessExcess)
            return std::nullopt;
        if (gained < 1e-6)
            break;
    }
    if (state->distortion > options.maxDistortion)
        return std::nullopt;
    return OptimizedMap{state->map(), 0, trial.patch().steps(), {}};
}

//! Removes the least promising runs until `count` are left. \returns the Newton steps of the removed ones
int keepMostPromising(std::vector<std::unique_ptr<Run>> &runs, int count)
{
    std::stable_sort(runs.begin(), runs.end(), [](const auto &a, const auto &b) {
        const int faultsOfA = a->anchorFaults(), faultsOfB = b->anchorFaults();
        return faultsOfA != faultsOfB ? faultsOfA < faultsOfB : a->expectedCost() < b->expectedCost();
    });
    int iterations = 0;
    while (static_cast<int>(runs.size()) > count) {
        iterations += runs.back()->searcher().steps();
        runs.pop_back();
    }
    return iterations;
}

//! First cuts and their map. \param number every number gives other cuts
//! \returns nothing when the map has flipped triangles, or overlaps that are not allowed
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
    int iterations = 0;
    std::vector<std::unique_ptr<Run>> runs(effort.seeds + given);
    const auto begin = [&](int i) {
        std::optional<CutState> state =
            i < effort.seeds ? firstMap(graph, options, i)
                             : usable(CutState::from(graph, options.given[i - effort.seeds], true), options);
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
                runs[i]->takeToBound();
        });
        std::erase_if(runs, [](const auto &run) { return !run; });
        if (runs.empty())
            return std::nullopt;
    }
    for (const auto &run : runs)
        iterations += run->searcher().steps();
    const auto better = [](const std::unique_ptr<Run> &a, const std::unique_ptr<Run> &b) {
        const int faultsOfA = a->anchorFaults(), faultsOfB = b->anchorFaults();
        if (faultsOfA != faultsOfB)
            return faultsOfA < faultsOfB;
        return a->fits() != b->fits() ? a->fits() : a->bestScore() < b->bestScore();
    };
    Run &best = **std::min_element(runs.begin(), runs.end(), better);
    return OptimizedMap{best.best().map(), best.searcher().mu(), iterations, best.best().anchorFaults()};
}

} // namespace autocuts::search
