// Triangulation of one polygon. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <array>
#include <vector>

namespace autocuts {

//! The area vector of a closed 3D polygon: its direction is the normal, its length twice the area.
Vec3 polygonNormal(const std::vector<Vec3> &points);

//! The first point from which a fan turns no triangle against the polygon's normal; -1 when there is none.
//! The rule must not change: tools that measure the map have to split polygons in the same way.
int fanApex(const std::vector<Vec3> &points);

//! Triangulates a polygon: a fan from fanApex() when there is one, ear clipping in the plane of the polygon
//! otherwise, and a fan from the first point when the polygon is so twisted that ear clipping turns triangles
//! over as well. Always gives n - 2 triangles with each side of the polygon in exactly one of them. Takes
//! about n log n steps except on contrived shapes.
//! \pre points.size() >= 3
//! \returns triangles as indices into points, in the winding of the polygon
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3> &points);

//! The same for a known result of fanApex().
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3> &points, int apex);

} // namespace autocuts
