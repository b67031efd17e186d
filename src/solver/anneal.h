// The automatic schedule of the homotopy: delta halved level by level.
#pragma once

#include "solver/solver.h"

#include <atomic>
#include <functional>

namespace autocuts {

//! Above this delta (mesh area pi) the separation is so smooth that lowering delta changes little.
inline constexpr double smoothDelta = 0.0625;

//! How long a run of the homotopy takes.
struct AnnealOptions
{
    double startDelta = 1;    //!< about 0.01 to reheat: short, nearly shut cuts close again, wide open ones stay
    double lambda = 0.05;
    int stepsPerLevel = 40;
};

//! Number of steps that annealSoup() will take.
int annealSteps(const Soup &soup, const AnnealOptions &options);

//! Lowers delta from options.startDelta to finalDelta(), by quarters down to smoothDelta and by halves below
//! (paper, Algorithm 1), with options.stepsPerLevel Newton steps at each level. A level ends early when its steps gain
//! nothing any more. The snapshot's lambda and delta are replaced; everything else in it is kept.
//! \param onStep called after each step
//! \returns the last step
StepResult annealSoup(Solver &solver, const AnnealOptions &options, const std::atomic<bool> *cancel,
                      const std::function<void(const StepResult &)> &onStep = {});

} // namespace autocuts
