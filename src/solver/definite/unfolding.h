// What cannot be cut apart and yet covers itself.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"

#include <atomic>

namespace autocuts::definite {

//! A *unit* is a set of triangles that no seam may part: a polygon, or polygons that the user joined. Gives
//! the units that lie over themselves a new shape, with little distortion, as charts of their own. A unit
//! keeps what it has when that does not help, as for joins that go round a tube.
void unfoldUnits(const Soup &soup, const Snapshot &snapshot, SeamedMap &map, const JobContext &job = {});

} // namespace autocuts::definite
