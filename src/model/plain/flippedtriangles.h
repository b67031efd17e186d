// Finds the flipped triangles of a UV map.
#pragma once

#include "model/plain/meshdata.h"

#include <span>

namespace autocuts {

//! Returns which triangles have the opposite orientation to their island as a whole. An island is mirrored
//! when the sum of its signed areas is negative. Triangles without UV area are not flipped. Renderers draw
//! these triangles; UvMetrics may split polygons without a fan differently.
//! \param soupUv three rows per triangle
//! \param islands the island of each face, -1 for a face without UVs
std::vector<bool> flippedTriangles(const MeshData &mesh, const UvMatrix &soupUv,
                                   std::span<const int> islands);

} // namespace autocuts
