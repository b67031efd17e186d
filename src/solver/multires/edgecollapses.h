// Chooses the edges that are collapsed to make a surface coarser, and their order.
#pragma once

#include "model/plain/types.h"
#include "solver/base/jobcontext.h"

#include <vector>

namespace autocuts::multires {

//! Half-edge collapse: one end of an edge moves onto the other.
struct HalfEdgeCollapse
{
    int removed, kept; //!< points
};

//! A surface of triangles that are connected across their sides. Corner and side k of triangle t have the
//! number 3 t + k.
struct CollapsingSurface
{
    const std::vector<Vec3> &position; //!< per point
    //! Per corner, counter-clockwise in each triangle. The triangles around a point form one fan.
    const std::vector<int> &point;
    const std::vector<int> &across;  //!< per side: the same side in the neighbour, -1 at a border
    const std::vector<bool> &alive;  //!< per triangle: true when it is part of the surface
    const std::vector<bool> &locked; //!< per point: true when it must stay
};

//! The collapses of a quadric error decimation (Garland and Heckbert 1997), cheapest first, until `triangles`
//! are left or nothing can be collapsed. No collapse makes the surface non-manifold, moves a border point
//! inside, flips a triangle or makes a sliver. Fewer when stopped. Runs OpenMesh's decimater.
std::vector<HalfEdgeCollapse> edgeCollapses(const CollapsingSurface &surface, int triangles,
                                            const JobContext &job = {});

} // namespace autocuts::multires
