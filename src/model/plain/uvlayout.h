// Functions on the UVs of a layout: rows per soup corner, bounding box and scale. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <Eigen/Geometry>

namespace autocuts {

//! The scale of a layout without UVs: the length in texture space of one solver unit. The mesh has area pi in
//! solver units, so a map without distortion then covers pi * 0.4^2, about half of the unit square.
inline constexpr double defaultUvScale = 0.4;

//! A layout in which no corner has a UV.
UvMatrix emptyLayout(const MeshData &mesh);
//! The UVs per soup corner, from UVs per corner. \pre uv has one row per corner
UvMatrix soupUv(const MeshData &mesh, const UvMatrix &uv);
//! True when the matrices are equal bit for bit, so that rows without UVs can be compared too.
bool sameBits(const UvMatrix &a, const UvMatrix &b);
//! The bounding box of the finite rows; empty when there are none.
Eigen::AlignedBox2d layoutBox(const UvMatrix &uv);
//! The scale of a layout: the length in texture space of one solver unit, in which the mesh has area pi. It
//! is chosen so that the layout, divided by it, has the area of the faces it covers. Without UVs it is
//! defaultUvScale.
double layoutScale(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
