// Maximal regions without overlaps (paper, figure 9 and "Removing self-overlaps").
#pragma once

#include "model/plain/meshdata.h"
#include "solver/overlap/overlapfinder.h"

#include <vector>

namespace autocuts::overlap {

struct UnitGraph;

//! A maximal region around a triangle that does not overlap itself in UV: grown breadth first over uncut edge
//! pairs, leaving out every polygon that overlaps the region so far. Polygons stay whole.
//! \param soupUv one row per soup corner
//! \param cut per edge pair
//! \return triangles in ascending order; those of the seed's polygon are always among them
//! \throws std::invalid_argument when a size does not fit the mesh
std::vector<int> cleanRegion(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                             int seedTriangle, const OverlapOptions &options = {});

//! Splits a set of units into such regions. Units with few overlaps are taken as seeds first.
//! \param part label of each unit; the units labelled `from` get labels from `nextPart` on
void splitIntoCleanRegions(const UnitGraph &graph, int from, std::vector<int> &part, int &nextPart);

} // namespace autocuts::overlap
