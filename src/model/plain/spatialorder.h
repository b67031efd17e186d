// Points in an order in which near ones mostly follow each other. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <vector>

namespace autocuts {

//! From this many faces on MeshData numbers the triangles in this order: fewer fit into near caches in any
//! order.
inline constexpr int spatiallyNumberedFaces = 4096;

//! Numbers of the points along a space-filling curve through them (the Z-order curve of Morton 1966); points
//! in one place keep their order. \pre all coordinates are finite
std::vector<int> spatialOrder(const PositionMatrix &points);

} // namespace autocuts
