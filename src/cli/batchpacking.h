// Packing as the command line is asked for it.
#pragma once

#include "cli/batchfiles.h"
#include "cli/clioptions.h"
#include "solver/unwrap/packjob.h"

namespace autocuts {

//! What to pack into the tile or the rectangle that the options name, by the locks, stacks and groups of the
//! session. When a stop was requested before there was a layout, a quick one is made all the same.
Result<unwrap::PackJob> batchPacking(const CliOptions &options, const BatchFiles &files,
                                     const MeshData &mesh);

//! That the islands do not fit, and what to do.
Error noRoomError(const CliOptions &options);

} // namespace autocuts
