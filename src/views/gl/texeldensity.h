// The texel density of every triangle of a map.
#pragma once

#include "model/plain/meshdata.h"

#include <span>
#include <vector>

namespace autocuts {

//! Texels per unit of the model, per triangle, divided by its texel weight, so that a map as it was painted
//! has the same everywhere; NaN for triangles without UVs or without area.
//! \param uv one row per soup corner \param textureSize texels along the width of the texture
std::vector<float> texelDensities(const MeshData &mesh, const UvMatrix &uv, int textureSize);

//! The density that half of the area of the model has at most; NaN when no triangle has a density.
//! \param densities one per triangle
double medianDensity(const MeshData &mesh, std::span<const float> densities);

} // namespace autocuts
