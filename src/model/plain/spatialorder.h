// Orders points along a space-filling curve. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <vector>

namespace autocuts {

//! Meshes with at least this many faces get their triangles numbered in this order. Chosen by hand: the data
//! of fewer triangles fits into the processor's caches in any order. Changing it changes the numbers of
//! edges, see hasNumbersOfVersion1().
inline constexpr int spatiallyNumberedFaces = 4096;

//! Sorts points along the Z-order curve of Morton (1966): points that are close in space mostly get close
//! numbers. Points in the same place keep their order. \pre all coordinates are finite
std::vector<int> spatialOrder(const PositionMatrix &points);

} // namespace autocuts
