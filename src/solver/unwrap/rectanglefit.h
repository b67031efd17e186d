// Makes charts fit into the rectangles that they belong to.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/unwrap/freepart.h"

#include <memory>

namespace autocuts::unwrap {

//! How far charts are deformed: the first few steps only, or until nothing is gained.
enum class FitEffort { Quick, Full };

//! Deforms charts that do not fit into their rectangle at their size, by the box energy of the paper
//! (equations 10 and 11), and leaves those as they are that would have to be distorted too much: packing
//! scales them down. Charts with pins stay.
//! \param map of the part without rectangles, without overlaps within a chart. Stays when the job is stopped
//! \returns false when all charts fit
bool fitToRectangles(const FreePart &part, const std::shared_ptr<const Soup> &soup, SeamedMap &map,
                     const JobContext &job = {}, FitEffort effort = FitEffort::Full);

} // namespace autocuts::unwrap
