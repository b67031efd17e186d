// An island as input of the packer. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <array>
#include <vector>

namespace autocuts::packing {

//! What the packer moves rigidly as one: a chart, or several charts of a stack or group.
struct PackIsland
{
    std::vector<Vec2> points;                  //!< UV units; points that are not usable are ignored
    std::vector<std::array<int, 3>> triangles; //!< indices into points, any winding
    std::vector<std::array<int, 2>> boundary;  //!< boundary edges, indices into points
    bool locked = false;                       //!< keeps its place and size as an obstacle for the others
    bool upright = false;                      //!< is not turned
    bool aligned = false;                      //!< is turned by right angles only
};

} // namespace autocuts::packing
