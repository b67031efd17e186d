// How far a drag in the map reaches, and how far it may go.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! The pieces of a map that are dragged at, and how much each of their corners follows.
struct DragReach
{
    std::vector<int> corners; //!< soup corners of the pieces, rising
    std::vector<double>
        weight; //!< per soup corner of the mesh: 1 dragged, falling smoothly to 0 at the radius
};

//! Distances are taken from each corner to the nearest dragged one, but reach it only over triangles and
//! closed corner pairs: what lies beyond a gap does not follow. Corners in one place get one weight.
//! \param soupUv one row per soup corner
//! \param separation per corner pair, 0 joined to 1 cut
//! \param handles soup corners that are dragged; those without UVs are left out
//! \param radius in the unit of the map
DragReach dragReach(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<float> &separation,
                    const std::vector<int> &handles, double radius);

//! The largest share in [0, 1] of these ways that leaves every triangle on the side where it is, with at
//! least a hundredth of its area. Triangles without area or without UVs do not count. \param soupUv, ways one
//! row per soup corner
double shareWithoutFlips(const UvMatrix &soupUv, const UvMatrix &ways);

} // namespace autocuts
