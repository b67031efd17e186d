// One island alone in the bin.
#pragma once

#include "solver/packing/layoutcheck.h"

#include <optional>

namespace autocuts::packing {

//! Turns the only movable island so that its box allows the largest scale; exact up to the angle's last
//! digits, because only the convex hull matters.
//! \return nothing when there are several islands, obstacles, or no extent
[[nodiscard]] std::optional<Layout> fitSingleIsland(const PackProblem &problem, WorkMeter &work);

} // namespace autocuts::packing
