// How much of the surroundings each place of a surface can be seen from (ambient occlusion).
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts::preference {

//! Per vertex: share of the half-sphere above the surface, weighted by the cosine, in which nothing of the
//! mesh is in the way, in [0, 1]; 0 is hidden, 1 is open. Where a vertex has no normal (isolated, or a sheet
//! folded onto itself) it is 1. The same rays at every vertex up to a turn, so the result is the same every
//! time. \param threads the result does not depend on it
std::vector<double> vertexOpenness(const MeshData &mesh, int threads = 1);

//! Per edge pair: mean of its ends.
std::vector<double> edgeOpenness(const MeshData &mesh, int threads = 1);

} // namespace autocuts::preference
