// Finds the edges at which the flat parts of a model end.
#pragma once

#include "solver/bake/rayscene.h"

namespace autocuts::bake {

//! For each triangle, the edges that are no farther away than `reach` and at which the flat part of the
//! surface ends that the triangle belongs to: by more than a degree, or open. In the frame.
std::vector<std::vector<std::array<Vec3f, 2>>> bentEdgesNear(const MeshData &mesh, const Frame &frame,
                                                             float reach);

} // namespace autocuts::bake
