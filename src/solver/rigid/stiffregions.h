// What the search has to know about the regions that keep their shape.
#pragma once

#include "model/plain/snapshot.h"

#include <memory>

namespace autocuts::rigid {

//! The rigid regions of a mesh with their stiffness and the edges that are always seams; null when it has
//! none.
[[nodiscard]] std::shared_ptr<const RigidRegions> rigidRegions(const std::shared_ptr<const MeshData> &mesh,
                                                               const std::vector<bool> &creases);

} // namespace autocuts::rigid
