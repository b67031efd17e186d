// Which edges of a surface are collapsed to make it coarser, and in which order.
#pragma once

#include "model/plain/types.h"

#include <vector>

namespace autocuts::multires {

//! One end of an edge moves onto the other.
struct HalfEdgeCollapse
{
    int removed, kept; //!< points
};

//! Triangles over points, next to each other across their sides; corner and side k of triangle t are 3 t + k.
struct CollapsingSurface
{
    const std::vector<Vec3> &position; //!< per point
    const std::vector<int> &point;  //!< per corner, counter-clockwise; the triangles around a point are a fan
    const std::vector<int> &across; //!< per side: the same side of the neighbour, -1 at a border
    const std::vector<bool> &alive; //!< per triangle: whether it is there
    const std::vector<bool> &locked; //!< per point: whether it stays
};

//! The collapses of a quadric error decimation (Garland and Heckbert 1997) until that many triangles are left
//! or nothing can be collapsed any more: those first that change the surface least; none pinches the surface,
//! leaves a border for the inside, turns a triangle over or makes it a sliver. Runs OpenMesh's decimater.
std::vector<HalfEdgeCollapse> edgeCollapses(const CollapsingSurface &surface, int triangles);

} // namespace autocuts::multires
