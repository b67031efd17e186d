// Splitting one polygon into triangles. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <array>
#include <vector>

namespace autocuts {

//! Area vector of a closed 3D polygon: normal direction, length twice the area.
Vec3 polygonNormal(const std::vector<Vec3> &points);

//! First point from which a fan turns no triangle against the polygon's normal; -1 when there is none. The
//! rule is a contract: tools that measure the map must split polygons in the same way.
int fanApex(const std::vector<Vec3> &points);

//! Triangles (indices into points, in the polygon's winding) that cover the polygon: a fan from fanApex()
//! when there is one, ear clipping in the plane of the polygon otherwise, or a fan from the first point where
//! the polygon is so twisted that ears fold it as well. Always n - 2 triangles, each side of the polygon in
//! exactly one of them. About n log n steps but for contrived shapes. \pre points.size() >= 3
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3> &points);

//! The same when the result of fanApex() is known already.
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3> &points, int apex);

} // namespace autocuts
