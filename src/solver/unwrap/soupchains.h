// The paper's method for the automatic mode: chains of annealing runs on the triangle soup.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/unwrap/candidates.h"

#include <optional>

namespace autocuts::unwrap {

//! True when so many edges have three or more faces that the pairs of faces chosen there wind through each
//! other, as those of loosely extracted surfaces do.
bool isTangled(const MeshData &mesh);

//! Runs several different chains, on the job's threads, and returns the best of their definite maps. When the
//! job is stopped before any map was found, the first map is still completed in few steps.
//! \param hurried little time is spent on the definite maps, for a draft that shortens their seams itself
//! \param iterations the number of Newton steps is added to it
std::optional<Candidate> bestOfSoupChains(const Snapshot &snapshot, const UnwrapOptions &options,
                                          bool hurried, Ranking &ranking, const JobContext &job,
                                          int &iterations);

} // namespace autocuts::unwrap
