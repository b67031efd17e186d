#include "solver/homotopy/anneal.h"

#include <cmath>

namespace autocuts::homotopy {

std::vector<double> deltaLevels(const Soup &soup, double start)
{
    const double last = finalDelta(soup);
    std::vector<double> levels;
    for (double delta = start; delta > last; delta *= delta > smoothDelta ? 0.25 : 0.5)
        levels.push_back(delta);
    levels.push_back(last);
    return levels;
}

bool hasStalled(double energyBefore, const StepResult &step)
{
    // Least relative change of the energy. Chosen by hand.
    constexpr double stall = 1e-9;
    return step.stepLength == 0 || std::abs(energyBefore - step.energy) < stall * energyBefore;
}

int annealSteps(const Soup &soup, const AnnealOptions &options)
{
    return static_cast<int>(deltaLevels(soup, options.startDelta).size()) * options.stepsPerLevel;
}

StepResult annealSoup(Solver &solver, const AnnealOptions &options, const JobContext &job,
                      const std::function<void(const StepResult &)> &onStep)
{
    StepResult last;
    for (const double delta : deltaLevels(solver.soup(), options.startDelta)) {
        Snapshot snapshot = solver.snapshot();
        snapshot.settings.lambda = options.lambda;
        snapshot.settings.delta = delta;
        solver.update(snapshot);
        double energy = 0;
        for (int i = 0; i < options.stepsPerLevel; ++i) {
            if (job.stopped())
                return last;
            last = solver.step();
            job.addWork(solver.soup().triangleCount());
            if (onStep)
                onStep(last);
            if (hasStalled(i > 0 ? energy : 0, last))
                break;
            energy = last.energy;
        }
    }
    return last;
}

} // namespace autocuts::homotopy
