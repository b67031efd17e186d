// Prepares packing with the options of the command line.
#pragma once

#include "cli/batchfiles.h"
#include "cli/clioptions.h"
#include "solver/unwrap/packjob.h"

namespace autocuts {

//! The packing job for the tile or rectangle in the options, with the steering of the session. When a stop is
//! requested before there is a layout, packing still makes a quick one.
Result<unwrap::PackJob> batchPacking(const CliOptions &options, const BatchFiles &files,
                                     const Snapshot &snapshot);

//! The error that the islands do not fit, with a remedy.
Error noRoomError(const CliOptions &options);

} // namespace autocuts
