#include "solver/pipeline.h"

#include "solver/anneal.h"
#include "solver/budget.h"
#include "solver/chartmerge.h"
#include "solver/overlap/overlapseparation.h"
#include "solver/overlapfree.h"
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

constexpr int relaxSteps = 60;
constexpr double optimizingShare = 0.9; // of the progress bar
constexpr double hurriedPackEffort = 0.1;
constexpr int hurriedSteps = 4;
constexpr int extraRuns = 5; // when none of the planned ones met the bound
constexpr int mergeRounds = 4;
constexpr int mergeWork = 500'000; // tries times triangles

//! One chain of annealing runs, each reheated from the end of the one before. Where it ends depends on luck as
//! much as on the parameters, so several different ones are run and the best map is kept. The first chain starts
//! as the user asked, the others as it says here.
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
    double seedDistortion = 0; //!< before seams were closed: what the lambda led to
};

//! Corner pairs that must not be cut: those that the user joined.
std::vector<bool> protectedEdges(const Snapshot &snapshot)
{
    std::vector<bool> joined(snapshot.mesh->edgePairs.size(), false);
    for (std::size_t p = 0; p < snapshot.pairState.size(); ++p) {
        if (snapshot.pairState[p] == PairState::Joined)
            joined[p / 2] = true;
    }
    return joined;
}

UvMatrix soupUv(const std::vector<double> &x)
{
    return Eigen::Map<const UvMatrix>(x.data(), static_cast<Eigen::Index>(x.size() / 2), 2);
}

ChartMap chartsOf(const MeshData &mesh, const CutMesh &state)
{
    ChartMap charts;
    charts.count = state.chartCount;
    charts.faceChart.assign(mesh.faceCount(), -1);
    for (int t = 0; t < mesh.triangleCount(); ++t)
        charts.faceChart[mesh.triangleFace[t]] = state.chart[t];
    return charts;
}

//! Gives every chart the texel density of the whole.
void equalizeDensity(const Soup &soup, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    UvMatrix uv = cornerUv(soup, map);
    equalizeTexelDensity(mesh, chartsOf(mesh, CutMesh(mesh, map.cut)), uv);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        map.x[2 * static_cast<std::size_t>(c)] = uv(mesh.cornerOfSoup(c), 0);
        map.x[2 * static_cast<std::size_t>(c) + 1] = uv(mesh.cornerOfSoup(c), 1);
    }
}

//! Relaxes a map as far as it may: without covering itself, unless that is allowed.
void relaxAsAllowed(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, bool allowOverlaps,
                    SeamedMap &map, const std::atomic<bool> *stop)
{
    SeamedMap relaxed = map;
    relaxMap(soup, snapshot, relaxed, relaxSteps, stop);
    if (!allowOverlaps && coversItself(*soup, relaxed)) {
        // The free way led over itself; the guarded one is slower.
        relaxed = map;
        relaxWithoutOverlaps(soup, snapshot, relaxed, relaxSteps, stop);
        if (coversItself(*soup, relaxed))
            return;
    }
    map = std::move(relaxed);
}

//! Joins charts and closes seams as long as the bound leaves room for it.
void shortenSeams(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                  const UnwrapOptions &options, SeamedMap &map, const std::atomic<bool> *stop)
{
    MergeOptions merge;
    merge.maxDistortion = options.lambda ? std::numeric_limits<double>::infinity() : options.maxDistortion;
    if (options.lambda)
        merge.costPerLength = *options.lambda / std::max(1 - *options.lambda, 1e-9);
    merge.allowOverlaps = options.allowOverlaps;
    // A try costs time in proportion to the mesh.
    merge.tries = std::clamp(mergeWork / soup->triangleCount(), 10, 300);
    merge.cancel = stop;
    for (int round = 0; round < mergeRounds && !(stop && stop->load()); ++round) {
        const int closed = mergeCharts(soup, snapshot, map, merge) + zipSeams(soup, snapshot, map, merge);
        if (closed == 0)
            break;
        relaxAsAllowed(soup, snapshot, options.allowOverlaps, map, stop);
    }
}

//! The definite map that the solver's state stands for, with its figures.
Candidate evaluate(const Solver &solver, const UnwrapOptions &options, const std::atomic<bool> *stop)
{
    const std::shared_ptr<const Soup> soup = solver.sharedSoup();
    const Snapshot &snapshot = solver.snapshot();
    Candidate result;
    result.lambda = snapshot.settings.lambda;
    result.delta = snapshot.settings.delta;
    result.map = finishMap(soup, snapshot, solver.coordinates());
    relaxMap(soup, snapshot, result.map, relaxSteps, stop);
    if (!options.allowOverlaps) {
        removeOverlaps(*soup, snapshot, result.map);
        relaxAsAllowed(soup, snapshot, false, result.map, stop);
    }
    result.seedDistortion = result.map.distortion(*soup);
    shortenSeams(soup, snapshot, options, result.map, stop);
    equalizeDensity(*soup, result.map);
    result.distortion = result.map.distortion(*soup);
    result.seamLength = result.map.seamLength(*soup);
    return result;
}

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

    void found(const Candidate &candidate)
    {
        const std::scoped_lock lock(mMutex);
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
    int mSteps = 0;
    UnwrapProgress mProgress;
};

struct ChainResult
{
    std::optional<Candidate> best;
    int iterations = 0;
};

ChainResult runChain(const Snapshot &start, const ChainPlan &plan, bool first, const QualityPlan &quality,
                     const UnwrapOptions &options, Ranking &ranking, const std::atomic<bool> *stop)
{
    const auto stopped = [&] { return stop && stop->load(std::memory_order_relaxed); };
    Snapshot snapshot = start;
    snapshot.settings.delta = 1;
    if (!first)
        snapshot.settings.start = plan.start;
    Solver solver;
    solver.load(snapshot);
    DistortionBudget budget(options.maxDistortion, plan.firstLambda);
    ChainResult result;
    // A run that misses the bound may be followed by some more than planned.
    const int mostRuns = quality.runs + (options.lambda ? 0 : extraRuns);
    for (int run = 0; run < mostRuns && (!stopped() || !result.best); ++run) {
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
            if (result.best)
                break;
            // Whatever is still half open has to be decided: the rest of the homotopy in a few steps.
            anneal.startDelta = solver.snapshot().settings.delta;
            anneal.stepsPerLevel = hurriedSteps;
            annealSoup(solver, anneal, nullptr);
        }
        Candidate candidate = evaluate(solver, options, stop);
        budget.report(candidate.seedDistortion);
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

void place(const Soup &soup, const SeamedMap &map, const UnwrapOptions &options, bool hurry,
           const std::atomic<bool> *stop, Ranking &ranking, UvMatrix &uv)
{
    uv = cornerUv(soup, map);
    if (!options.pack) {
        fitUnitSquare(uv);
        return;
    }
    const MeshData &mesh = *soup.mesh;
    const ChartMap charts = chartsOf(mesh, CutMesh(mesh, map.cut));
    PackSettings settings = options.packing;
    settings.threads = options.threads;
    if (hurry)
        settings.effort = std::min(settings.effort, hurriedPackEffort);
    const PackResult packed =
        packIslands(makePackIslands(mesh, uv, charts), settings, hurry ? nullptr : stop, [&](double done) {
            ranking.stage(UnwrapStage::Packing, optimizingShare + (1 - optimizingShare) * done);
        });
    if (!packed.complete)
        throw std::invalid_argument("unwrap: there is no room for the margins around so many islands");
    applyPlacements(packed, mesh, charts, uv);
}

void checkOptions(const UnwrapOptions &options)
{
    if (!(options.maxDistortion > 4))
        throw std::invalid_argument("unwrap: the distortion bound must be above 4, the value of an isometry");
    if (options.lambda && !(*options.lambda >= 0 && *options.lambda <= 1))
        throw std::invalid_argument("unwrap: lambda must be between 0 and 1");
}

} // namespace

UvMatrix cornerUv(const Soup &soup, const SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        uv(mesh.cornerOfSoup(c), 0) = map.x[2 * static_cast<std::size_t>(c)];
        uv(mesh.cornerOfSoup(c), 1) = map.x[2 * static_cast<std::size_t>(c) + 1];
    }
    return uv;
}

bool removeOverlaps(const Soup &soup, const Snapshot &snapshot, SeamedMap &map,
                    const std::atomic<bool> *cancel)
{
    SeparationOptions options;
    options.cancel = cancel;
    if (!snapshot.pairWeight.empty()) {
        options.pairWeight.resize(map.cut.size());
        for (std::size_t e = 0; e < map.cut.size(); ++e)
            options.pairWeight[e] = 0.5 * (snapshot.pairWeight[2 * e] + snapshot.pairWeight[2 * e + 1]);
    }
    SeparationResult result =
        separateOverlaps(*soup.mesh, soupUv(map.x), map.cut, protectedEdges(snapshot), options);
    if (!result.complete)
        return false;
    map.cut = std::move(result.cut);
    return true;
}

UnwrapResult unwrap(const Snapshot &snapshot, const UnwrapOptions &options, const std::atomic<bool> *stop,
                    const std::function<void(const UnwrapProgress &)> &progress)
{
    checkOptions(options);
    const std::shared_ptr<const Soup> soup = Soup::build(snapshot.mesh);
    const QualityPlan plan = planFor(options.quality, soup->triangleCount());
    int steps = 0;
    for (int i = 0; i < plan.chains; ++i)
        steps += annealSteps(*soup, {1, 0, plan.stepsPerLevel}) +
                 (plan.runs - 1) * annealSteps(*soup, {chainPlans[i].reheat, 0, plan.stepsPerLevel});
    Ranking ranking(options, steps, progress);

    std::vector<ChainResult> results(plan.chains);
    parallelFor(plan.chains, options.threads, [&](int i) {
        results[i] = runChain(snapshot, chainPlans[i], i == 0, plan, options, ranking, stop);
    });

    UnwrapResult result;
    const Candidate *best = nullptr;
    for (const ChainResult &chain : results) {
        result.iterations += chain.iterations;
        if (!best || ranking.better(*chain.best, *best))
            best = &*chain.best;
    }
    result.stopped = stop && stop->load();
    result.cut = best->map.cut;
    result.distortion = best->distortion;
    result.seamLength = best->seamLength;
    result.lambda = best->lambda;
    result.delta = best->delta;
    result.withinBound = options.lambda || best->distortion <= options.maxDistortion;
    place(*soup, best->map, options, result.stopped, stop, ranking, result.uv);
    result.stopped = stop && stop->load();
    return result;
}

} // namespace autocuts
