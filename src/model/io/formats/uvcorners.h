// Corners that share a UV in formats that give UVs numbers of their own.
#pragma once

#include "model/plain/meshdata.h"

#include <span>
#include <vector>

namespace autocuts {

//! For every corner, the first corner of the same vertex whose UV has the same bits; -1 without a finite UV.
//! \param vertexOfCorner in the range of vertexCount \param uv one row per corner
std::vector<int> sharedUvCorners(std::span<const int> vertexOfCorner, int vertexCount, const UvMatrix &uv);

//! The same by the welded vertices of a mesh. \param uv one row per corner of the mesh
std::vector<int> sharedUvCorners(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
