#include "solver/pipeline.h"

#include "solver/anneal.h"
#include "solver/budget.h"
#include "solver/mapmaking.h"
#include "solver/multires/coarsetofine.h"
#include "solver/packing/islandgeometry.h"
#include "solver/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

namespace autocuts {

namespace {

constexpr double optimizingShare = 0.9; // of the progress bar
constexpr double hurriedPackEffort = 0.1;
constexpr int hurriedSteps = 4;
constexpr int extraRuns = 5; // when none of the planned ones met the bound

//! One chain of annealing runs, each reheated from the end of the one before. Where it ends depends on luck
//! as much as on the parameters, so several different ones are run and the best map is kept. The first chain
//! starts as the user asked, the others as it says here.
struct ChainPlan
{
    double firstLambda;
    double reheat; //!< delta where the second and further runs start
    StartMode start;
};

constexpr std::array<ChainPlan, 12> chainPlans{{{0.05, 0.01, StartMode::Rigid},
                                                {0.05, 0.01, StartMode::Tutte},
                                                {0.3, 0.05, StartMode::Rigid},
                                                {0.3, 0.01, StartMode::Tutte},
                                                {0.1, 0.02, StartMode::Random},
                                                {0.02, 0.05, StartMode::Tutte},
                                                {0.2, 0.03, StartMode::Rigid},
                                                {0.1, 0.05, StartMode::Tutte},
                                                {0.15, 0.005, StartMode::Random},
                                                {0.03, 0.03, StartMode::Rigid},
                                                {0.4, 0.02, StartMode::Tutte},
                                                {0.02, 0.01, StartMode::Rigid}}};

struct QualityPlan
{
    int chains;
    int runs; //!< per chain
    int stepsPerLevel;
};

//! Small meshes get more chains: they cost little and their result depends more on luck.
QualityPlan planFor(UnwrapQuality quality, int triangles)
{
    const auto chains = [triangles](int work, int fewest) {
        return std::clamp(work / std::max(triangles, 1), fewest, static_cast<int>(chainPlans.size()));
    };
    switch (quality) {
    case UnwrapQuality::Draft:
        return {chains(4000, 1), 2, 20};
    case UnwrapQuality::Standard:
        return {chains(10000, 2), 4, 40};
    case UnwrapQuality::Best:
        return {chains(80000, 4), 6, 60};
    }
    throw std::invalid_argument("unwrap: unknown quality");
}

struct Candidate
{
    SeamedMap map;
    double distortion = 0, seamLength = 0, lambda = 0, delta = 0;
};

//! Collects what the chains find; shared between threads.
class Ranking
{
public:
    Ranking(const UnwrapOptions &options, int totalSteps,
            const std::function<void(const UnwrapProgress &)> &report)
        : mOptions(options), mTotalSteps(totalSteps), mReport(report)
    {}

    //! Shorter seams win among those within the bound, lower distortion outside of it.
    bool better(const Candidate &a, const Candidate &b) const
    {
        if (mOptions.lambda) {
            const double mu = *mOptions.lambda / std::max(1 - *mOptions.lambda, 1e-9);
            return a.distortion + mu * a.seamLength < b.distortion + mu * b.seamLength;
        }
        const bool aFits = a.distortion <= mOptions.maxDistortion;
        const bool bFits = b.distortion <= mOptions.maxDistortion;
        if (aFits != bFits)
            return aFits;
        return aFits ? a.seamLength < b.seamLength : a.distortion < b.distortion;
    }

    void stepDone(int steps)
    {
        if (!mReport)
            return;
        const std::scoped_lock lock(mMutex);
        mSteps += steps;
        mProgress.fraction = optimizingShare * std::min(1.0, double(mSteps) / mTotalSteps);
        mReport(mProgress);
    }

    //! True when some chain has found a map.
    bool hasAny() const { return mHasAny; }

    void found(const Candidate &candidate)
    {
        const std::scoped_lock lock(mMutex);
        mHasAny = true;
        if (mProgress.distortion == 0 || candidate.seamLength < mProgress.seamLength) {
            mProgress.distortion = candidate.distortion;
            mProgress.seamLength = candidate.seamLength;
        }
    }

    void stage(UnwrapStage stage, double fraction)
    {
        if (!mReport)
            return;
        const std::scoped_lock lock(mMutex);
        mProgress.stage = stage;
        mProgress.fraction = fraction;
        mReport(mProgress);
    }

private:
    const UnwrapOptions &mOptions;
    int mTotalSteps;
    const std::function<void(const UnwrapProgress &)> &mReport;
    std::mutex mMutex;
    std::atomic<bool> mHasAny = false;
    int mSteps = 0;
    UnwrapProgress mProgress;
};

//! Start of chain i where it is not the one that the user asked for. The second chain complements the first.
std::optional<StartMode> startOf(int i, StartMode asked)
{
    if (i == 0)
        return std::nullopt;
    if (i == 1 && asked == chainPlans[1].start)
        return chainPlans[0].start;
    return chainPlans[i].start;
}

struct ChainResult
{
    std::optional<Candidate> best;
    int iterations = 0;
};

ChainResult runChain(const Snapshot &start, const ChainPlan &plan, std::optional<StartMode> startMode,
                     const QualityPlan &quality, const UnwrapOptions &options, Ranking &ranking,
                     const std::atomic<bool> *stop)
{
    const auto stopped = [&] { return stop && stop->load(std::memory_order_relaxed); };
    Snapshot snapshot = start;
    snapshot.settings.delta = 1;
    if (startMode)
        snapshot.settings.start = *startMode;
    Solver solver;
    solver.load(snapshot);
    DistortionBudget budget(options.maxDistortion, plan.firstLambda);
    MapMakingOptions making;
    making.allowOverlaps = options.allowOverlaps;
    making.maxDistortion = options.maxDistortion;
    if (options.lambda) {
        making.maxDistortion = std::numeric_limits<double>::infinity();
        making.costPerLength = *options.lambda / std::max(1 - *options.lambda, 1e-9);
    }
    ChainResult result;
    // A run that misses the bound may be followed by some more than planned.
    const int mostRuns = quality.runs + (options.lambda ? 0 : extraRuns);
    for (int run = 0; run < mostRuns && !(stopped() && ranking.hasAny()); ++run) {
        const bool fits = result.best && result.best->distortion <= options.maxDistortion;
        if (run >= quality.runs && (fits || options.lambda))
            break;
        AnnealOptions anneal;
        anneal.startDelta = run == 0 ? 1 : plan.reheat;
        anneal.lambda = options.lambda.value_or(budget.lambda());
        anneal.stepsPerLevel = quality.stepsPerLevel;
        annealSoup(solver, anneal, stop, [&](const StepResult &) {
            ++result.iterations;
            ranking.stepDone(1);
        });
        if (stopped()) {
            if (ranking.hasAny())
                break;
            // Whatever is still half open has to be decided: the rest of the homotopy in a few steps.
            anneal.startDelta = solver.snapshot().settings.delta;
            anneal.stepsPerLevel = hurriedSteps;
            annealSoup(solver, anneal, nullptr);
        }
        // The first map must come about, whatever is asked meanwhile.
        std::optional<MadeMap> made = makeMap(solver, making, ranking.hasAny() ? stop : nullptr);
        if (!made)
            break;
        budget.report(made->seedDistortion);
        Candidate candidate;
        candidate.map = std::move(made->map);
        candidate.distortion = candidate.map.distortion(solver.soup());
        candidate.seamLength = candidate.map.seamLength(solver.soup());
        candidate.lambda = solver.snapshot().settings.lambda;
        candidate.delta = solver.snapshot().settings.delta;
        ranking.found(candidate);
        if (!result.best || ranking.better(candidate, *result.best))
            result.best = std::move(candidate);
    }
    return result;
}

void fitUnitSquare(UvMatrix &uv)
{
    const Eigen::RowVector2d low = uv.colwise().minCoeff();
    const Eigen::RowVector2d high = uv.colwise().maxCoeff();
    const double side = (high - low).maxCoeff();
    uv.rowwise() -= low;
    if (side > 0)
        uv /= side;
}

//! Fills result.uv and result.packed.
void place(const Soup &soup, const SeamedMap &map, const UnwrapOptions &options,
           const std::atomic<bool> *stop, Ranking &ranking, UnwrapResult &result)
{
    result.uv = cornerUv(soup, map);
    if (!options.pack) {
        fitUnitSquare(result.uv);
        return;
    }
    const MeshData &mesh = *soup.mesh;
    const ChartMap charts = chartsOf(mesh, CutMesh(mesh, map.cut));
    const std::vector<PackIsland> islands = makePackIslands(mesh, result.uv, charts);
    PackSettings settings = options.packing;
    settings.threads = options.threads;
    const auto pack = [&](const std::atomic<bool> *cancel) {
        return packIslands(islands, settings, cancel, [&](double done) {
            ranking.stage(UnwrapStage::Packing, optimizingShare + (1 - optimizingShare) * done);
        });
    };
    PackResult packed;
    if (!(stop && stop->load()))
        packed = pack(stop);
    if (!packed.complete) {
        // Stopped before the first layout, or there is no room: a hurried attempt tells.
        settings.effort = std::min(settings.effort, hurriedPackEffort);
        packed = pack(nullptr);
    }
    result.packed = packed.complete;
    if (packed.complete)
        applyPlacements(packed, mesh, charts, result.uv);
    else
        fitUnitSquare(result.uv);
}

void checkOptions(const UnwrapOptions &options)
{
    if (!(options.maxDistortion > 4))
        throw std::invalid_argument("unwrap: the distortion bound must be above 4, the value of an isometry");
    if (options.lambda && !(*options.lambda >= 0 && *options.lambda <= 1))
        throw std::invalid_argument("unwrap: lambda must be between 0 and 1");
}

//! The way of large meshes; nothing when this mesh does not take it.
std::optional<UnwrapResult> unwrapLarge(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                        const UnwrapOptions &options, const std::atomic<bool> *stop,
                                        const std::function<void(const UnwrapProgress &)> &progress)
{
    if (!suitsCoarseToFine(snapshot))
        return std::nullopt;
    const std::optional<CarriedMap> carried = mapByCoarse(
        soup, snapshot, options,
        [&](const Snapshot &coarse, const UnwrapOptions &coarseOptions) {
            return unwrap(coarse, coarseOptions, stop, progress);
        },
        stop);
    if (!carried)
        return std::nullopt;
    UnwrapResult result;
    result.iterations = carried->iterations;
    result.cut = carried->map.cut;
    result.distortion = carried->map.distortion(*soup);
    result.seamLength = carried->map.seamLength(*soup);
    result.lambda = carried->lambda;
    result.delta = carried->delta;
    result.withinBound = options.lambda || result.distortion <= options.maxDistortion;
    Ranking ranking(options, 1, progress);
    place(*soup, carried->map, options, stop, ranking, result);
    result.stopped = stop && stop->load();
    return result;
}

} // namespace

UnwrapResult unwrap(const Snapshot &snapshot, const UnwrapOptions &options, const std::atomic<bool> *stop,
                    const std::function<void(const UnwrapProgress &)> &progress)
{
    checkOptions(options);
    const std::shared_ptr<const Soup> soup = Soup::build(snapshot.mesh);
    if (std::optional<UnwrapResult> large = unwrapLarge(soup, snapshot, options, stop, progress))
        return std::move(*large);
    const QualityPlan plan = planFor(options.quality, soup->triangleCount());
    int steps = 0;
    for (int i = 0; i < plan.chains; ++i)
        steps += annealSteps(*soup, {1, 0, plan.stepsPerLevel}) +
                 (plan.runs - 1) * annealSteps(*soup, {chainPlans[i].reheat, 0, plan.stepsPerLevel});
    Ranking ranking(options, steps, progress);

    std::vector<ChainResult> results(plan.chains);
    parallelFor(plan.chains, options.threads, [&](int i) {
        results[i] = runChain(snapshot, chainPlans[i], startOf(i, snapshot.settings.start), plan, options,
                              ranking, stop);
    });

    UnwrapResult result;
    const Candidate *best = nullptr;
    for (const ChainResult &chain : results) {
        result.iterations += chain.iterations;
        if (chain.best && (!best || ranking.better(*chain.best, *best)))
            best = &*chain.best;
    }
    result.stopped = stop && stop->load();
    result.cut = best->map.cut;
    result.distortion = best->distortion;
    result.seamLength = best->seamLength;
    result.lambda = best->lambda;
    result.delta = best->delta;
    result.withinBound = options.lambda || best->distortion <= options.maxDistortion;
    place(*soup, best->map, options, stop, ranking, result);
    result.stopped = stop && stop->load();
    return result;
}

} // namespace autocuts
