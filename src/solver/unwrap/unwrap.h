// The whole way from a snapshot to a packed UV map: one path for the window and the command line.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/unwrap/unwrapoptions.h"

#include <atomic>
#include <functional>

namespace autocuts::unwrap {

//! Makes the UV map. Deterministic unless stopped. When `stop` becomes true the job ends early with the best
//! valid map so far: seams finished, separated and packed with little effort.
//! \param progress called now and then, from one thread at a time but not always the same one
//! \throws std::invalid_argument when the mesh has no area or an option is out of range
[[nodiscard]] UnwrapResult unwrapMesh(const Snapshot &snapshot, const UnwrapOptions &options,
                                      const JobContext &job = {});

} // namespace autocuts::unwrap
