// Where the solver starts (paper, section 4 "Initialization" and figure 5).
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::homotopy {

//! Coordinates for the snapshot's start mode, every triangle positively oriented:
//! - Rigid: each triangle undistorted, centred on the origin of its component;
//! - Tutte: each component cut open to a disk and mapped to a circle; triangles that shrink out of all
//!   proportion are placed rigidly where the map puts them;
//! - Random: each triangle undistorted, turned and placed at random (settings.seed);
//! - ExistingUv: the snapshot's start UVs; triangles that are flipped or have no UVs are placed rigidly.
std::vector<double> initialUv(const Soup &soup, const Snapshot &snapshot);

} // namespace autocuts::homotopy
