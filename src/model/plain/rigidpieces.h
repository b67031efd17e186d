// Groups the charts that packing moves together.
//
// A *piece* is one chart, or all charts of one stack or group.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/islandflags.h"

namespace autocuts {

//! The charts of a map, united into one piece where they belong to one stack or group.
struct RigidPieces
{
    ChartMap pieces;
    std::vector<bool> locked;  //!< per piece: it keeps its place, and others are packed around it
    std::vector<bool> upright; //!< per piece: it is not turned
    std::vector<bool> aligned; //!< per piece: it is turned by right angles only
};

//! Unites the charts into pieces.
//! \param movable per face; a piece without a movable face is locked. Empty: all faces are movable
RigidPieces rigidPieces(const ChartMap &charts, const std::vector<IslandFlags> &faceFlags,
                        const std::vector<bool> &movable = {});

//! The number of the stack of each chart; 0: none. \param faceFlags per face; empty: none is stacked
std::vector<int> stackOfCharts(const ChartMap &charts, const std::vector<IslandFlags> &faceFlags);

} // namespace autocuts
