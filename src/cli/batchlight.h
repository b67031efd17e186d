// Bakes light into a picture.
#pragma once

#include "cli/batchbake.h"

namespace autocuts {

//! Bakes the lights of the options into the UV map of a scene, and writes the picture; after a stop, what
//! there is of it. With several tiles, the number of each stands before the suffix.
//! \param files that have read the scene \param stop that of the job
Result<BakeOutcome> bakeLights(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                               const std::atomic<bool> &stop, const JobContext &job);

} // namespace autocuts
