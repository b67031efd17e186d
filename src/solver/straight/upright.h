// Turns the islands of a map upright.
#pragma once

#include "model/plain/solvesettings.h"
#include "solver/base/seamedmap.h"
#include "solver/base/soup.h"

namespace autocuts::straight {

//! The map with its islands turned so that a direction of the model is up, see angleToUp(). Islands with
//! straight borders stand on the axes, by that right angle which is nearest. \param up Y or Z
[[nodiscard]] SeamedMap turnedUpright(const Soup &soup, const SeamedMap &map, WorldUp up);

} // namespace autocuts::straight
