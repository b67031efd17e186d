// How far two surfaces that lie on each other are apart, and the cage for a bake that follows. Plain: no Qt.
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

//! How far the cage around a model should be from it so that a bake finds nearly all of a detailed model: a
//! share of the diagonal of the model's bounding box, in steps of a hundredth of a percent. Takes long.
//! \param high lies where the model does \returns nothing when it is nowhere near, or when it was stopped
std::optional<double> proposedCage(const MeshData &low, const MeshData &high, const std::atomic<bool> &stop);

} // namespace autocuts::transfer
