// From the live soup to a real UV map: joins what is nearly joined, cuts the rest (paper, section 4,
// "Finalizing the UV map"), without a flipped or degenerate triangle.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"

#include <atomic>
#include <vector>

namespace autocuts::definite {

//! Merges the corner pairs whose separation is below 0.5 (always on diagonals and joined pairs, never on cut
//! ones) and puts each merged corner at the average. Where that would flip a triangle the pairs are pulled
//! together step by step with the distortion minimised; what still flips stays cut.
//! \pre every triangle is positively oriented at x
SeamedMap stitchSoup(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                     const std::vector<double> &x, const JobContext &job = {});

//! Closes the given map to other cut flags, as stitchSoup() does. Edges that cannot be closed stay cut.
SeamedMap stitchTo(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, CutFlags cut,
                   const std::vector<double> &x, const JobContext &job = {});

//! Minimises the distortion (and pins and rectangles) with the seams fixed, at most `steps` Newton steps or
//! until the energy stalls. Returns the number of steps.
int relaxMap(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map, int steps,
             const JobContext &job = {});

} // namespace autocuts::definite
