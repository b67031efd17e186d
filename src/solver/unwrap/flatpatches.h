// The map that can always be made at once: many near-flat patches.
#pragma once

#include "solver/base/seamedmap.h"

namespace autocuts::unwrap {

//! Cuts the mesh into near-flat patches and projects each along its normal, so that no triangle is flipped
//! and no chart overlaps itself. Polygons stay whole: one that is not flat enough becomes a chart of its own.
//! The user's cuts are kept; joined edges are cut where patches end there. The time grows about linearly with
//! the size of the mesh. For jobs that end before they have found a better map.
[[nodiscard]] SeamedMap flatPatches(const Soup &soup, const Snapshot &snapshot);

} // namespace autocuts::unwrap
