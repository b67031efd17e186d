#include "solver/unwrap/soupchains.h"

#include "model/plain/parallel.h"
#include "solver/base/constant.h"
#include "solver/definite/definitemap.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/budget.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! More runs of a chain when none of the planned ones met the bound, at most.
AUTOCUTS_CONSTANT(int, extraRuns, 5);

//! One chain of annealing runs, each reheated from the end of the one before: delta goes back to `reheat`, so
//! that short, nearly shut seams close and wide open ones stay (reheating at lambda 0.05 took the seam of the
//! cow from 11.7 to 6.9). The result varies strongly with start and parameters, so several different chains
//! are run and the best map is kept. The first chain starts as the user asked, the others as the plan says.
struct ChainPlan
{
    double firstLambda;
    double reheat; //!< delta at the start of the second and further runs
    StartMode start;
};

// The first plan is the one that served hand and triceratops. The others vary it over the range tried there
// (lambda 0.05 to 0.3, reheating to 0.01) and beyond.
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
    int runs;             //!< per chain
    int stepsPerLevel;    //!< Newton steps at each delta, at most
    bool oneFits = false; //!< a chain ends with its first run that meets the bound
};

//! Share of edges with three or more faces. See also MapSearch::suitsClusters().
constexpr double tangledEdges = 0.1;
//! Lambda of a draft's first run on a tangled mesh. With the plans' values that misses the bound. On
//! two generated meshes of 15,000 and 72,000 triangles, a draft with .008 and one run takes 6.5 and 17 CPU
//! seconds in place of 15 and 63, for seams of 15.8 and 48.3 in place of 15.5 and 52.4.
constexpr double tangledLambda = 0.008;
//! Of the definite maps in hurried chains, see DefiniteMapOptions. Against 60 and 4, drafts of multiComp,
//! teapot and feline_half take .4, .8 and .7 of the time; their seams are 1, .92 and .83 times as long, those
//! of suzanne 1.04 times.
AUTOCUTS_CONSTANT(int, hurriedSteps, 8);
constexpr int hurriedRounds = 1;

//! Chains, runs and steps for a quality. Small meshes get more chains, because a chain costs little there and
//! its result varies more. On the first meshes (docs/constants.md) 40 to 60 fast steps per delta kept
//! improving the result.
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
    throw std::invalid_argument("unknown quality");
}

//! Start mode of chain i: the first takes the one that was asked for, and the second another one.
StartMode startOf(int i, StartMode asked)
{
    if (i == 0)
        return asked;
    if (i == 1 && asked == chainPlans[1].start)
        return chainPlans[0].start;
    return chainPlans[i].start;
}

struct ChainResult
{
    std::optional<Candidate> best;
    int iterations = 0;
};

ChainResult runChain(const Snapshot &start, const ChainPlan &plan, const QualityPlan &quality,
                     const UnwrapOptions &options, bool hurried, Ranking &ranking, const JobContext &job)
{
    Snapshot snapshot = start;
    snapshot.settings.delta = 1;
    homotopy::Solver solver;
    solver.load(snapshot);
    homotopy::DistortionBudget budget(options.maxDistortion, plan.firstLambda);
    definite::DefiniteMapOptions making;
    making.allowOverlaps = options.allowOverlaps;
    making.maxDistortion = options.maxDistortion;
    if (hurried) {
        making.relaxSteps = hurriedSteps;
        making.joinRounds = hurriedRounds;
    }
    if (options.lambda) {
        making.maxDistortion = std::numeric_limits<double>::infinity();
        making.costPerLength = *options.lambda / std::max(1 - *options.lambda, 1e-9);
    }
    ChainResult result;
    // A run that misses the bound may be followed by some more than planned.
    const int mostRuns = quality.runs + (options.lambda ? 0 : extraRuns);
    for (int run = 0; run < mostRuns && !job.stopped(); ++run) {
        const bool fits = result.best && result.best->distortion <= options.maxDistortion;
        if ((quality.oneFits && fits) || (run >= quality.runs && (fits || options.lambda)))
            break;
        homotopy::AnnealOptions anneal;
        anneal.startDelta = run == 0 ? 1 : plan.reheat;
        anneal.lambda = options.lambda.value_or(budget.lambda());
        anneal.stepsPerLevel = quality.stepsPerLevel;
        homotopy::annealSoup(solver, anneal, job, [&](const homotopy::StepResult &) {
            ++result.iterations;
            ranking.stepDone(1);
        });
        if (job.stopped())
            break;
        std::optional<definite::DefiniteMap> made = definite::makeDefiniteMap(solver, making, job.quiet());
        if (!made)
            break;
        budget.report(made->seedDistortion);
        Candidate candidate;
        candidate.map = std::move(made->map);
        candidate.measure(solver.soup(), snapshot);
        candidate.lambda = solver.snapshot().settings.lambda;
        candidate.delta = solver.snapshot().settings.delta;
        ranking.offer(candidate, [&] { return candidate.map; });
        if (!result.best || ranking.better(candidate, *result.best))
            result.best = std::move(candidate);
    }
    return result;
}

} // namespace

bool isTangled(const MeshData &mesh)
{
    return mesh.report.nonManifoldEdges > tangledEdges * double(mesh.edgePairs.size());
}

std::optional<Candidate> bestOfSoupChains(const Snapshot &snapshot, const UnwrapOptions &options,
                                          bool hurried, Ranking &ranking, const JobContext &job,
                                          int &iterations)
{
    const std::shared_ptr<const Soup> soup = Soup::build(snapshot.mesh);
    const bool tangledDraft = hurried && isTangled(*snapshot.mesh);
    QualityPlan plan = planFor(options.quality, soup->triangleCount());
    plan.oneFits = tangledDraft;
    int steps = 0;
    for (int i = 0; i < plan.chains; ++i)
        steps +=
            homotopy::annealSteps(*soup, {1, 0, plan.stepsPerLevel}) +
            (plan.runs - 1) * homotopy::annealSteps(*soup, {chainPlans[i].reheat, 0, plan.stepsPerLevel});
    ranking.setTotal(steps);

    std::vector<ChainResult> results(plan.chains);
    parallelFor(plan.chains, job.threads(), [&](int i) {
        Snapshot start = snapshot;
        start.settings.start = startOf(i, snapshot.settings.start);
        ChainPlan chain = chainPlans[i];
        if (tangledDraft)
            chain.firstLambda = std::min(chain.firstLambda, tangledLambda);
        results[i] = runChain(start, chain, plan, options, hurried, ranking, job);
    });
    std::optional<Candidate> best;
    for (ChainResult &chain : results) {
        iterations += chain.iterations;
        if (chain.best && (!best || ranking.better(*chain.best, *best)))
            best = std::move(chain.best);
    }
    return best;
}

} // namespace autocuts::unwrap
