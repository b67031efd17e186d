// The automatic schedule of the homotopy: delta halved level by level.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/homotopy/solver.h"

#include <atomic>
#include <functional>
#include <vector>

namespace autocuts::homotopy {

//! Above this delta (mesh area pi) the separation is so smooth that lowering delta changes little.
inline constexpr double smoothDelta = 0.0625;

//! How long a run of the homotopy takes.
struct AnnealOptions
{
    double startDelta = 1; //!< about 0.01 to reheat: short, nearly shut cuts close again, wide open ones stay
    double lambda = 0.05;
    int stepsPerLevel = 40;
};

//! The falling deltas of the homotopy, from `start` to finalDelta(): by quarters down to smoothDelta, by
//! halves below (paper, Algorithm 1).
std::vector<double> deltaLevels(const Soup &soup, double start);

//! True when a step gained so little against the one before that more of them at this delta are in vain.
bool hasStalled(double energyBefore, const StepResult &step);

//! Number of steps that annealSoup() will take.
int annealSteps(const Soup &soup, const AnnealOptions &options);

//! Takes options.stepsPerLevel Newton steps at each of deltaLevels(). A level ends early when it has stalled.
//! The snapshot's lambda and delta are replaced; everything else in it is kept. \param onStep called after
//! each step \returns the last step
StepResult annealSoup(Solver &solver, const AnnealOptions &options, const JobContext &job,
                      const std::function<void(const StepResult &)> &onStep = {});

} // namespace autocuts::homotopy
