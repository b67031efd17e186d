// The exact test that every layout must pass before it is accepted.
#pragma once

#include "solver/packing/segmentgrid.h"
#include "solver/packing/workmeter.h"

namespace autocuts::packing {

//! All edges of all islands as placed, sorted by island.
std::vector<PlacedEdge> placedEdges(const PackProblem &problem, const Layout &layout);

//! True when every movable island lies in the bin and keeps the gutter to every other island: no edges
//! cross or come nearer than the gutter, and no part of an island lies inside another one. Locked islands are
//! not tested against each other, nor an island against itself.
bool isValidLayout(const PackProblem &problem, const Layout &layout, WorkMeter &work);

} // namespace autocuts::packing
