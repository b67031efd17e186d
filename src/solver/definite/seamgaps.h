// Makes seams visible in the UVs: adjacent charts must not coincide along their seam.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/definite/stitching.h"

namespace autocuts::definite {

//! Width of a gap between the two sides of a seam.
//! \param meanEdge mean length of an edge in the map
//! \param diagonal diagonal of the map's box, in the same units; the result is in them too
double seamGap(double meanEdge, double diagonal);

//! Opens gaps at seams whose two sides have the same UVs. Seams are not stored in UVs, so such a seam does
//! not exist for programs that read them, and its two charts count as one. Moves the less important (smaller)
//! of the two charts aside by a thousandth of an edge; charts with pins are moved last.
void openSeams(const Soup &soup, const Snapshot &snapshot, SeamedMap &map);

} // namespace autocuts::definite
