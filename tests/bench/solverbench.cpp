#include "bench/solverbench.h"

#include "solver/energy/distortion.h"
#include "solver/energy/separation.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/solver.h"
#include "solver/newton/minimizer.h"
#include "solver/newton/newtondirection.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>

namespace autocuts::bench {

using namespace energy;

using namespace homotopy;

using namespace newton;

namespace {

constexpr int stepsPerWarmLevel = 8;
constexpr int blockCount = 5;
constexpr int largeMesh = 30'000;
//! Races that the fast step runs, for the median: they are over too soon for one to tell much.
constexpr int fastRuns = 5;

std::unique_ptr<Solver> loaded(const WarmState &state, SolverKind kind, int threads)
{
    Snapshot snapshot = state.snapshot;
    snapshot.settings.solver = kind;
    auto solver = std::make_unique<Solver>();
    solver->setThreads(threads);
    solver->load(snapshot);
    solver->setCoordinates(state.x);
    return solver;
}

double cpuMilliseconds(const std::function<void()> &job)
{
    const Time start = Time::now();
    job();
    return 1e3 * (Time::now() - start).cpu;
}

//! Median of the CPU milliseconds of some calls after one that does not count.
double typical(int calls, const std::function<void()> &job)
{
    job();
    std::vector<double> times;
    for (int i = 0; i < calls; ++i)
        times.push_back(cpuMilliseconds(job));
    return median(times);
}

//! The terms of the energy at a warm state.
struct Energy
{
    std::unique_ptr<DistortionTerm> distortion;
    SeparationTerm separation;

    Energy(const WarmState &state, const std::shared_ptr<const Soup> &soup, ThreadTeam *team)
        : distortion(makeDistortionTerm(soup, DistortionEnergy::SymmetricDirichlet, team)),
          separation(soup, team)
    {
        distortion->setFactor(1 - state.snapshot.settings.lambda);
        separation.setFactor(state.snapshot.settings.lambda);
        separation.setDelta(state.snapshot.settings.delta);
        separation.setWeights(pairWeights(*soup, state.snapshot));
    }
};

void measureParts(const WarmState &state, const std::shared_ptr<const Soup> &soup, StepCost &cost)
{
    const Energy energy(state, soup, nullptr);
    double sum = 0;
    cost.value =
        typical(5, [&] { sum += energy.separation.value(state.x) + energy.distortion->value(state.x); });
    const auto direction = makeHubDirection(soup, {});
    HessianBlocks blocks;
    std::vector<double> gradient, move(state.x.size());
    cost.derivatives = typical(5, [&] {
        blocks.resize(soup->triangleCount(), static_cast<int>(soup->pairCorners.size()),
                      direction->precision());
        gradient.assign(state.x.size(), 0.0);
        energy.distortion->addDerivatives(state.x, gradient, blocks);
        energy.separation.addDerivatives(state.x, gradient, blocks);
    });
    // It uses the blocks up.
    std::vector<HessianBlocks> copies(6, blocks);
    std::size_t next = 0;
    cost.direction = typical(5, [&] { direction->compute(copies[next++], gradient, move); });
}

//! Runs `step`, which returns the energy, until `goal` is reached. Returns the number of steps, 0 when it is
//! not reached in `most`.
template <class Step>
int stepsTo(double goal, int most, Step &&step)
{
    for (int i = 1; i <= most; ++i) {
        if (step() <= goal)
            return i;
    }
    return 0;
}

//! The hundredth part of the triangles nearest to triangle 0.
std::vector<int> neighbourhood(const MeshData &mesh)
{
    std::vector<std::pair<double, int>> distance;
    const Vec3 centre = mesh.cornerPosition(mesh.triangles[0][0]);
    for (int t = 0; t < mesh.triangleCount(); ++t)
        distance.emplace_back((mesh.cornerPosition(mesh.triangles[t][0]) - centre).squaredNorm(), t);
    std::sort(distance.begin(), distance.end());
    std::vector<int> result;
    for (int i = 0; i < std::max(1, mesh.triangleCount() / 100); ++i)
        result.push_back(distance[i].second);
    return result;
}

} // namespace

Time Time::now()
{
    timespec cpu;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return {double(cpu.tv_sec) + 1e-9 * double(cpu.tv_nsec), std::chrono::duration<double>(wall).count()};
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

WarmState warmState(const test::MeshPtr &mesh, double lambda, double delta, int threads)
{
    WarmState state;
    state.snapshot.mesh = mesh;
    state.snapshot.settings.lambda = lambda;
    state.snapshot.settings.delta = 0.0625;
    Solver solver;
    solver.setThreads(threads);
    solver.load(state.snapshot);
    for (double &level = state.snapshot.settings.delta;; level = std::max(0.5 * level, delta)) {
        solver.update(state.snapshot);
        for (int i = 0; i < stepsPerWarmLevel; ++i)
            solver.step();
        if (level <= delta)
            break;
    }
    state.x = solver.coordinates();
    return state;
}

StepCost measureSteps(const WarmState &state, bool exact, int threads)
{
    StepCost cost;
    const bool large = state.snapshot.mesh->triangleCount() > largeMesh;
    const auto fast = loaded(state, SolverKind::Fast, threads);
    fast->step();
    std::vector<double> cpu, wall;
    // Blocks, not single steps: the factor that some steps renew belongs to all of them.
    const int steps = 10;
    for (int block = 0; block < (large ? 3 : blockCount); ++block) {
        const Time start = Time::now();
        for (int i = 0; i < steps; ++i)
            fast->step();
        const Time used = Time::now() - start;
        cpu.push_back(1e3 * used.cpu / steps);
        wall.push_back(1e3 * used.wall / steps);
    }
    cost.fast = median(cpu);
    cost.fastWall = median(wall);
    measureParts(state, fast->sharedSoup(), cost);
    if (exact) {
        const auto reference = loaded(state, SolverKind::Exact, 1);
        cost.exact = typical(large ? 2 : 5, [&] { reference->step(); });
    }
    return cost;
}

RaceResult race(const WarmState &state, int steps, int threads)
{
    RaceResult result;
    const auto exact = loaded(state, SolverKind::Exact, 1);
    double goal = 0;
    result.exact = cpuMilliseconds([&] {
        for (int i = 0; i < steps; ++i)
            goal = exact->step().energy;
    });
    const int most = 20 * steps;
    std::unique_ptr<Solver> fast;
    std::vector<double> runs;
    for (int run = 0; run < fastRuns; ++run) {
        fast = loaded(state, SolverKind::Fast, threads);
        runs.push_back(cpuMilliseconds(
            [&] { result.fastSteps = stepsTo(goal, most, [&] { return fast->step().energy; }); }));
    }
    result.fast = median(runs);

    const std::shared_ptr<const Soup> soup = fast->sharedSoup();
    ThreadTeam team(threads);
    const Energy energy(state, soup, &team);
    Minimizer general(soup, makeHubDirection(soup, {}, &team, HubFactor::General), &team);
    general.setTerms({energy.distortion.get(), &energy.separation});
    std::vector<double> x = state.x;
    result.general = cpuMilliseconds([&] { stepsTo(goal, most, [&] { return general.step(x).after; }); });
    return result;
}

std::vector<EditResult> measureEdits(const WarmState &state, int threads)
{
    const MeshData &mesh = *state.snapshot.mesh;
    const std::vector<int> triangles = neighbourhood(mesh);
    std::vector<bool> inside(mesh.triangleCount(), false);
    for (const int t : triangles)
        inside[t] = true;
    std::vector<int> pairs, corners;
    for (int p = 0; p < mesh.cornerPairCount(); ++p) {
        if (inside[mesh.edgePairs[p / 2].triangle[0]])
            pairs.push_back(p);
    }
    for (const int t : triangles)
        corners.insert(corners.end(), {3 * t, 3 * t + 1, 3 * t + 2});
    const auto at = [&](int corner) {
        return Vec2(state.x[2 * static_cast<std::size_t>(corner)],
                    state.x[2 * static_cast<std::size_t>(corner) + 1]);
    };
    const auto setStates = [&](Snapshot &s, PairState pairState) {
        Steering &steering = s.editSteering();
        steering.pairState.assign(mesh.cornerPairCount(), PairState::Free);
        for (const int p : pairs)
            steering.pairState[p] = pairState;
    };
    const std::vector<std::pair<std::string, std::function<void(Snapshot &)>>> edits{
        {"cut", [&](Snapshot &s) { setStates(s, PairState::Cut); }},
        {"join", [&](Snapshot &s) { setStates(s, PairState::Joined); }},
        {"paint",
         [&](Snapshot &s) {
             Steering &steering = s.editSteering();
             steering.pairWeight.assign(mesh.cornerPairCount(), 1.0);
             for (const int p : pairs)
                 steering.pairWeight[p] = 3;
         }},
        {"soft pin",
         [&](Snapshot &s) {
             s.editSteering().pins.push_back({corners[0], at(corners[0]) + Vec2(0.1, 0), false, 10});
         }},
        {"hard pin",
         [&](Snapshot &s) {
             s.editSteering().pins.push_back({corners[0], at(corners[0]), true, 1});
         }},
        {"box",
         [&](Snapshot &s) {
             s.editSteering().rectangles.push_back(
                 {at(corners[0]) - Vec2(0.1, 0.1), at(corners[0]) + Vec2(0.1, 0.1), corners, false, 1});
         }},
    };
    std::vector<EditResult> results;
    for (const auto &[name, change] : edits) {
        const auto solver = loaded(state, SolverKind::Fast, threads);
        const double usual = typical(10, [&] { solver->step(); });
        Snapshot snapshot = solver->snapshot();
        change(snapshot);
        // The changed step and the nine after it, against ten usual ones: what the artist waits for.
        const double edited = cpuMilliseconds([&] {
            solver->update(snapshot);
            solver->step();
        });
        results.push_back({name, edited, edited / usual});
    }
    return results;
}

QualityResult compareQuality(const test::MeshPtr &mesh, double lambda, int seeds, int threads)
{
    QualityResult result;
    const auto run = [&](SolverKind kind, double &mean, double &error, double &seconds) {
        std::vector<double> energies;
        const Time start = Time::now();
        for (int seed = 1; seed <= seeds; ++seed) {
            Snapshot snapshot;
            snapshot.mesh = mesh;
            snapshot.settings.solver = kind;
            snapshot.settings.start = StartMode::Random;
            snapshot.settings.seed = static_cast<unsigned>(seed);
            Solver solver;
            solver.setThreads(kind == SolverKind::Fast ? threads : 1);
            solver.load(snapshot);
            const int steps = kind == SolverKind::Fast ? 40 : 20;
            energies.push_back(annealSoup(solver, {1, lambda, steps}, nullptr).energy);
        }
        seconds = (Time::now() - start).cpu;
        double squares = 0;
        for (const double energy : energies)
            mean += energy / seeds;
        for (const double energy : energies)
            squares += (energy - mean) * (energy - mean);
        error = seeds > 1 ? std::sqrt(squares / (seeds - 1) / seeds) : 0;
    };
    run(SolverKind::Fast, result.fast, result.fastError, result.fastSeconds);
    run(SolverKind::Exact, result.exact, result.exactError, result.exactSeconds);
    return result;
}

} // namespace autocuts::bench
