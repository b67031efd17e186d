// Cuts a definite map along edges at once, without a solve.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"

#include <vector>

namespace autocuts::definite {

//! A map after a rip.
struct RippedMap
{
    UvMatrix uv;            //!< one row per corner, texture space
    std::vector<int> edges; //!< the edge pairs that are cut, ascending
    int wereOpen = 0;       //!< how many of them were seams before
    int closed = 0;         //!< how many of them are no seams yet: they end nowhere, so that they cannot open
    int locked = 0;         //!< edges left out because an island at them is locked
    int newIslands = 0;     //!< how many islands the map has more than before
};

//! Cuts the map of the snapshot along edges. Where that splits an island, its smaller parts, and those
//! without hard pins, move aside by about the gutter if there is room near. Where there is none, and where an
//! island is only slit, the two sides open by a small gap (openSides()). Nothing else moves, and no triangle
//! flips. Locked islands stay whole. \param edges edges of MeshAdjacency; boundary sides and diagonals are
//! left out \param gutter texture space, > 0 \pre snapshot.uv is not null
RippedMap ripEdges(const Snapshot &snapshot, const std::vector<int> &edges, double gutter,
                   const JobContext &job = {});

} // namespace autocuts::definite
