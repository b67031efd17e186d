// Helpers on the UVs of a layout: rows per soup corner, box and scale. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <Eigen/Geometry>

namespace autocuts {

//! Length in texture space that one unit of the solver gets when there are no UVs to take it from: a map
//! without stretch then fills half of the unit square.
inline constexpr double defaultUvScale = 0.4;

//! A layout in which no corner has a UV.
UvMatrix emptyLayout(const MeshData &mesh);
//! The UVs of the soup corners: one row each, from one row per corner. \pre uv has a row per corner
UvMatrix soupUv(const MeshData &mesh, const UvMatrix &uv);
//! True when the matrices have the same bits; rows without UVs are equal when their bits are.
bool sameBits(const UvMatrix &a, const UvMatrix &b);
//! Box of the finite rows; empty when there is none.
Eigen::AlignedBox2d layoutBox(const UvMatrix &uv);
//! The scale of a layout: the length in texture space of one unit of the solver, in which the mesh has area
//! pi, so that the scaled-down layout has the area of the faces it covers. defaultUvScale without UVs.
double layoutScale(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
