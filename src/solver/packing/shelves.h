// Packing of bounding boxes in rows (shelves): the fallback that always works.
#pragma once

#include "solver/packing/layout.h"
#include "solver/packing/workmeter.h"

#include <optional>

namespace autocuts::packing {

//! Puts the islands' boxes in rows, tallest first, around the boxes of locked islands. The gutter is kept by
//! construction.
//! \return nothing when they do not fit at this scale
[[nodiscard]] std::optional<Layout> packShelves(const PackProblem &problem, double scale, WorkMeter &work);

} // namespace autocuts::packing
