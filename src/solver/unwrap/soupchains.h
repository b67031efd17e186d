// The paper's method for the automatic mode: chains of annealing runs on the triangle soup.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/unwrap/candidates.h"

#include <optional>

namespace autocuts::unwrap {

//! Runs several different chains, on the job's threads, and returns the best of their definite maps. When the
//! job is stopped before any map was found, the first map is still completed in few steps.
//! \param iterations the number of Newton steps is added to it
std::optional<Candidate> bestOfSoupChains(const Snapshot &snapshot, const UnwrapOptions &options,
                                          Ranking &ranking, const JobContext &job, int &iterations);

} // namespace autocuts::unwrap
