// What packing moves as one piece.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/islandflags.h"

namespace autocuts {

//! The charts of a map with those of one stack or one group made into one piece.
struct RigidPieces
{
    ChartMap pieces;
    std::vector<bool> locked; //!< per piece: an obstacle that keeps its place
};

//! \param movable per face: pieces without such a face are obstacles, as are the locked ones; empty: all are
RigidPieces rigidPieces(const ChartMap &charts, const std::vector<IslandFlags> &faceFlags,
                        const std::vector<bool> &movable = {});

} // namespace autocuts
