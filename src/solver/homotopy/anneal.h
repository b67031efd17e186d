// The automatic schedule of the homotopy: delta falls level by level.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/homotopy/solver.h"

#include <functional>
#include <vector>

namespace autocuts::homotopy {

//! Above this delta (mesh area pi) the separation is so smooth that lowering delta changes little: on the
//! first meshes (docs/constants.md), starting above 0.06 made no difference.
inline constexpr double smoothDelta = 0.0625;

//! Parameters of a run of the homotopy.
struct AnnealOptions
{
    double startDelta = 1; //!< about 0.01 to reheat: short, nearly closed cuts close, wide open ones stay
    double lambda = 0.05;
    //! On the first meshes 40 to 60 fast steps per level kept improving the result.
    int stepsPerLevel = 40;
};

//! The levels of delta from `start` down to finalDelta(): a quarter of the one before down to smoothDelta,
//! half of it below (paper, Algorithm 1).
std::vector<double> deltaLevels(const Soup &soup, double start);

//! True when a step changed the energy so little that more steps at this delta are not worth while.
bool hasStalled(double energyBefore, const StepResult &step);

//! Most steps that annealSoup() takes.
int annealSteps(const Soup &soup, const AnnealOptions &options);

//! Takes options.stepsPerLevel Newton steps at each of deltaLevels(). A level ends early when it has stalled.
//! Replaces lambda and delta of the solver's snapshot; everything else in it is kept.
//! \param onStep called after each step
//! \returns the last step
StepResult annealSoup(Solver &solver, const AnnealOptions &options, const JobContext &job,
                      const std::function<void(const StepResult &)> &onStep = {});

} // namespace autocuts::homotopy
