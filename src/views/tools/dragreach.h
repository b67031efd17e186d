// Computes how far the effect of a drag in the map extends, and how far it may go without flips.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! The islands that a drag affects, and how far each of their corners follows.
struct DragReach
{
    std::vector<int> corners; //!< soup corners of the islands, ascending
    std::vector<double>
        weight; //!< per soup corner of the mesh: 1 when dragged, decreasing smoothly to 0 at the radius
};

//! Computes the weights from the distance between each corner and the nearest dragged one. Only corners that
//! are connected over triangles and closed corner pairs follow: the effect does not cross gaps. Corners at
//! the same position get the same weight.
//! \param soupUv one row per soup corner
//! \param separation per corner pair, from 0 (closed) to 1 (cut)
//! \param handles soup corners that are dragged; those without UVs are ignored
//! \param radius in units of the map
DragReach dragReach(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<float> &separation,
                    const std::vector<int> &handles, double radius);

//! The largest share in [0, 1] of these displacements that flips no triangle and leaves each at least a
//! hundredth of its area (chosen by hand). Triangles without area or UVs are ignored.
//! \param soupUv, ways one row per soup corner
double shareWithoutFlips(const UvMatrix &soupUv, const UvMatrix &ways);

} // namespace autocuts
