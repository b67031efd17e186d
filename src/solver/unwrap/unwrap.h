// The job "unwrap" of the window and the command line: from a snapshot to a packed UV map.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/unwrap/unwrapoptions.h"

namespace autocuts::unwrap {

//! Unwraps the mesh: cuts, maps and packs it. The same arguments give the same bits unless the job is
//! stopped. When stopped, the job ends soon with the best valid map so far, packed with little effort.
//! \throws std::invalid_argument when the mesh has no area or an option is out of range
[[nodiscard]] UnwrapResult unwrapMesh(const Snapshot &snapshot, const UnwrapOptions &options,
                                      const JobContext &job = {});

} // namespace autocuts::unwrap
