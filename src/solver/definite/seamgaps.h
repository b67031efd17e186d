// Seams that can be told from the UVs alone.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/definite/stitching.h"

namespace autocuts::definite {

//! A seam between two charts that lies in one place on both sides is none for whoever reads the UVs: the two
//! count as one chart there. Moves the smaller chart of such a pair aside, by a thousandth of an edge; charts
//! with pins stay before all others.
void openSeams(const Soup &soup, const Snapshot &snapshot, SeamedMap &map);

} // namespace autocuts::definite
