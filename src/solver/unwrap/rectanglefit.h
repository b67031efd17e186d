// Makes charts fit into the rectangles that they belong to.
#pragma once

#include "solver/base/seamedmap.h"
#include "solver/unwrap/freepart.h"

#include <memory>

namespace autocuts::unwrap {

//! Deforms charts that do not fit into their rectangle at their size, by the box energy of the paper
//! (equations 10 and 11), and leaves those as they are that would have to be distorted too much: packing
//! scales them down. Charts with pins stay.
//! \param map of the part without rectangles, without overlaps within a chart
void fitToRectangles(const FreePart &part, const std::shared_ptr<const Soup> &soup, SeamedMap &map);

} // namespace autocuts::unwrap
