// Openness of a surface: the opposite of ambient occlusion.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts::preference {

//! Per vertex: share of the hemisphere above the surface, weighted by the cosine, that no part of the mesh
//! blocks, in [0, 1]; 0 is hidden, 1 is open. 1 where a vertex has no normal (isolated, or on a sheet folded
//! onto itself). All vertices use the same rays except for a rotation, so the result is always the same.
//! \param threads the result does not depend on it
std::vector<double> vertexOpenness(const MeshData &mesh, int threads = 1);

//! Per edge pair: mean openness of its two ends.
std::vector<double> edgeOpenness(const MeshData &mesh, int threads = 1);

} // namespace autocuts::preference
