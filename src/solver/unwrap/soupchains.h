// The paper's continuous way: chains of annealing runs on the triangle soup.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/unwrap/candidates.h"

#include <atomic>
#include <optional>

namespace autocuts::unwrap {

//! Runs several different chains, `options.threads` at a time, and returns the best map; the first one is
//! finished even when `stop` is set, unless some other map has been found before.
//! \param iterations receives the number of Newton steps
std::optional<Candidate> bestOfSoupChains(const Snapshot &snapshot, const UnwrapOptions &options,
                                          Ranking &ranking, const JobContext &job, int &iterations);

} // namespace autocuts::unwrap
