// The parts of an island's border that are straight on the model.
#pragma once

#include "solver/straight/island.h"

namespace autocuts::straight {

//! Points of an island that should lie on one line.
struct Chain
{
    std::vector<int> points; //!< in order, two at least
    double length = 0;       //!< on the model, solver units
    bool chosen = false;     //!< the user wants it straight
};

//! The chains of a border that are straight within the surface, however it is bent in space: both borders of
//! an unrolled tube, and the sides of a box. They end at corners, so that round borders have none. Short ones
//! are left out.
std::vector<Chain> straightChains(const Island &island);

} // namespace autocuts::straight
