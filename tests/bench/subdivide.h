// Larger meshes for measurements.
#pragma once

#include "support/meshbuilders.h"

namespace autocuts::bench {

//! Every triangle of the mesh split into four at the middles of its edges; shared edges stay shared.
test::MeshPtr subdivided(const MeshData &mesh);

} // namespace autocuts::bench
