// Relaxing a map that does not overlap itself, and keeping it so.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"

#include <atomic>

namespace autocuts::definite {

//! True when some chart covers itself.
bool coversItself(const Soup &soup, const SeamedMap &map);

//! Minimises the distortion (and rectangles and pins) with the seams fixed while no boundary may cross
//! itself, at most `steps` Newton steps or until the energy stalls. Returns the number of steps; 0 also when
//! some boundary touches itself from the start. \pre no chart covers itself
int relaxWithoutOverlaps(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
                         int steps, const JobContext &job = {});

} // namespace autocuts::definite
