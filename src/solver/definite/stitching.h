// Stitching: from the soup to a map with decided seams (paper, section 4, "Finalizing the UV map") without a
// flipped or degenerate triangle.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"

#include <functional>
#include <vector>

namespace autocuts::definite {

//! Merges the corner pairs whose separation is below 0.5 (always on diagonals and joined edges, never on
//! edges that the user cut) and puts merged corners at their mean. Where that would flip a triangle, springs
//! pull the pairs together while the distortion is minimised; edges that would still flip a triangle stay
//! cut.
//! \pre every triangle is positively oriented at x
SeamedMap stitchSoup(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                     const std::vector<double> &x, const JobContext &job = {});

//! Stitches a map to other cut flags in the same way. Edges that cannot be closed stay cut.
SeamedMap stitchTo(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, CutFlags cut,
                   const std::vector<double> &x, const JobContext &job = {});

//! Minimises the distortion, with pins, while the seams stay as they are. Ends after `steps`
//! Newton steps or when the energy stalls.
//! \param stepped called after each step with their number; may be empty
//! \param leastGain a step that gains less is the last: share of the energy above that of an isometry
//! \return the number of steps
int relaxMap(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map, int steps,
             const JobContext &job = {}, const std::function<void(int)> &stepped = {}, double leastGain = 0);

} // namespace autocuts::definite
