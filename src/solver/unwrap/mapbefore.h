// The map before a job as a map to start from.
#pragma once

#include "solver/base/seamedmap.h"

#include <optional>

namespace autocuts::unwrap {

//! The snapshot's map, in solver units, with the user's cuts; nothing when there is none, when it has flipped
//! triangles, or when it does not obey the joins.
[[nodiscard]] std::optional<SeamedMap> mapBefore(const Soup &soup, const Snapshot &snapshot);

} // namespace autocuts::unwrap
