// The exact test that every layout must pass before it is accepted.
#pragma once

#include "solver/packing/segmentgrid.h"
#include "solver/packing/workmeter.h"

namespace autocuts::packing {

//! The edges of all islands where the layout puts them, UV units, sorted by island.
std::vector<PlacedEdge> placedEdges(const PackProblem &problem, const Layout &layout);

//! True when every movable island lies in the bin and keeps the gutter to every other island: no edges of two
//! islands cross or come nearer than the gutter, and no connected part of an island lies inside another one.
//! Locked islands are not tested against each other, and no island against itself.
bool isValidLayout(const PackProblem &problem, const Layout &layout, WorkMeter &work);

} // namespace autocuts::packing
