// Packing of a single island.
#pragma once

#include "solver/packing/layoutcheck.h"

#include <optional>

namespace autocuts::packing {

//! Turns the only island so that its box allows the largest scale: samples the angle, then refines it. The
//! island stands in the middle.
//! \param ceiling on the scale
//! \return nothing when there are several islands, or the island is locked or has no extent
[[nodiscard]] std::optional<Layout> fitSingleIsland(const PackProblem &problem, double ceiling,
                                                    WorkMeter &work);

} // namespace autocuts::packing
