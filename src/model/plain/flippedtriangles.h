// Which triangles of a map are flipped.
#pragma once

#include "model/plain/meshdata.h"

#include <span>

namespace autocuts {

//! Triangles with UVs that are turned against their island, as textures are drawn with them: UvMetrics counts
//! those of a fan instead. Triangles without area are not flipped.
//! \param soupUv three rows per triangle \param islands per face, -1 without UVs
std::vector<bool> flippedTriangles(const MeshData &mesh, const UvMatrix &soupUv,
                                   std::span<const int> islands);

} // namespace autocuts
