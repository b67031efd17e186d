// Lays polygons (and joined groups of polygons) flat that overlap themselves and must not be cut.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"

namespace autocuts::definite {

//! A *unit* is a set of triangles that no seam may separate: a polygon, or polygons that the user joined.
//! Gives each unit that overlaps itself a new shape of low distortion, as a chart of its own. A unit keeps
//! its shape when the new one overlaps itself, too, as with joined polygons around a tube.
void unfoldUnits(const Soup &soup, const Snapshot &snapshot, SeamedMap &map, const JobContext &job = {});

} // namespace autocuts::definite
