// Relaxes a map without overlaps and keeps it free of them.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"

namespace autocuts::definite {

//! True when some chart overlaps itself.
bool coversItself(const Soup &soup, const SeamedMap &map);

//! Minimises the distortion, with pins, while the seams stay as they are and no chart's
//! boundary may cross itself. Ends after `steps` Newton steps or when the energy stalls.
//! \return the number of steps; 0 also when some boundary touches itself from the start
//! \pre no chart overlaps itself
int relaxWithoutOverlaps(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
                         int steps, const JobContext &job = {});

} // namespace autocuts::definite
