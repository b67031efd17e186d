// Start of the solver (paper, section 4 "Initialization" and figure 5).
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::homotopy {

//! Coordinates for the snapshot's start mode, every triangle positively oriented:
//! - Rigid: each triangle undistorted, with its centroid at the origin;
//! - Tutte: each component cut open to a disk and mapped to a circle; triangles that come out flipped or far
//!   too distorted are placed undistorted where the map puts them;
//! - Random: each triangle undistorted, at a random position and rotation (settings.seed);
//! - ExistingUv: the snapshot's start UVs; triangles that are flipped or have no UVs are placed undistorted.
std::vector<double> initialUv(const Soup &soup, const Snapshot &snapshot);

} // namespace autocuts::homotopy
