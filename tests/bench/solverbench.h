// Measurements of the solver: step cost, time to an energy, latency after an edit, time to a finished map.
#pragma once

#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <string>
#include <vector>

namespace autocuts::bench {

//! CPU seconds of this process, all threads; wall-clock seconds.
struct Time
{
    double cpu = 0, wall = 0;

    static Time now();
    Time operator-(const Time &other) const { return {cpu - other.cpu, wall - other.wall}; }
};

double median(std::vector<double> values);

//! Highest resident memory of the process so far, MB.
double peakMemory();

struct StepCost
{
    double fast = 0, fastWall = 0; //!< milliseconds of one step, all included; medians of blocks of steps
    double exact = 0;              //!< CPU milliseconds; 0 when not measured
    double value = 0, derivatives = 0,
           direction = 0; //!< parts of the fast step, CPU milliseconds of one call
};

//! A soup that has been annealed down to `delta`, ready to be measured from.
struct WarmState
{
    Snapshot snapshot;
    std::vector<double> x;
};

WarmState warmState(const test::MeshPtr &mesh, double lambda, double delta, int threads);

StepCost measureSteps(const WarmState &state, bool exact, int threads);

//! How long the solvers need, from the same start, to the energy that `steps` exact steps reach.
struct RaceResult
{
    double exact = 0, fast = 0; //!< CPU milliseconds; of the fast one, the median of several races
    double general = 0;         //!< of the fast solver when CHOLMOD factorises its hub matrix
    int fastSteps = 0;          //!< 0: not reached
};

RaceResult race(const WarmState &state, int steps, int threads);

//! Latency after a change of the steering around one place: update() and the next step, over a usual step.
struct EditResult
{
    std::string edit;
    double milliseconds = 0, stepRatio = 0;
};

//! Cuts, joins, paints, pins and boxes the hundredth part of the mesh nearest to one triangle.
std::vector<EditResult> measureEdits(const WarmState &state, int threads);

//! Energies at the end of the whole schedule from random starts, and their cost.
struct QualityResult
{
    double fast = 0, exact = 0;           //!< means over the seeds
    double fastError = 0, exactError = 0; //!< standard errors of the means
    double fastSeconds = 0, exactSeconds = 0;
};

//! Anneals from `seeds` random starts with both solvers. The cheap one takes twice the steps.
QualityResult compareQuality(const test::MeshPtr &mesh, double lambda, int seeds, int threads);

} // namespace autocuts::bench
