// An island as the packer is given it. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <array>
#include <vector>

namespace autocuts::packing {

//! One rigid piece of the UV map.
struct PackIsland
{
    std::vector<Vec2> points;                  //!< UV units; points that are not finite are ignored
    std::vector<std::array<int, 3>> triangles; //!< indices into points, any winding
    std::vector<std::array<int, 2>> boundary;  //!< open edges, indices into points
    bool locked = false;                       //!< keeps its place and size and is an obstacle
};

} // namespace autocuts::packing
