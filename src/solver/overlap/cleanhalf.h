// Splits a chart that overlaps itself into two parts without overlaps.
#pragma once

#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/unitgraph.h"

#include <vector>

namespace autocuts::overlap {

//! Splits the chart of a triangle along a short seam so that neither of the two parts overlaps itself. The
//! overlapping units are divided into two layers; of all minimum cuts between the layers the one with the
//! largest part at the triangle is taken. Polygons stay whole; the parts need not be connected.
//! \param soupUv one row per soup corner
//! \param cut per edge pair
//! \return the triangles of the part with the given triangle, in ascending order: the whole chart when it
//! does not overlap itself; empty when two parts are not enough (three layers, or overlaps in a ring of odd
//! length) or when cancelled
//! \throws std::invalid_argument when a size does not fit the mesh
std::vector<int> cleanHalf(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                           int seedTriangle, const OverlapOptions &options = {});

} // namespace autocuts::overlap
