// Cuts islands through where both parts can then lie along the axes.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"

namespace autocuts::straight {

//! Cuts islands through at their necks: along a path of edges between two points of the border, one of them
//! where the border turns inwards. A neck is worth its seam when much more of the border runs along the axes
//! once each part is turned by itself. The arms of a vehicle or a machine that unfold at odd angles become
//! islands of their own so. No part moves. Joined edges are not cut, islands with pins stay whole, and so do
//! all islands when the user decides the seams or wants them or the map symmetric.
//! \param aligned per connected component: its islands may be cut \returns true when something was cut
bool cutNecks(const Soup &soup, const Snapshot &snapshot, const std::vector<bool> &aligned, SeamedMap &map,
              const JobContext &job = {});

} // namespace autocuts::straight
