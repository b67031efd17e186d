// How far two surfaces that lie on each other are apart. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <atomic>
#include <optional>

namespace autocuts::transfer {

//! The distance within which nearly all vertices of each surface find the other one. Vertices that are
//! farther away than the limit belong to something else and do not count. \param stop ends it \returns
//! nothing when no vertex is within the limit, or when it was stopped
std::optional<double> surfaceDistance(const MeshData &a, const MeshData &b, double limit,
                                      const std::atomic<bool> &stop);

} // namespace autocuts::transfer
