// Charts that are copies of each other, such as those of repeated bolts or wheels. Plain: no Qt.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshadjacency.h"

#include <vector>

namespace autocuts {

//! How a chart matches another one that is moved, turned or mirrored on the model.
struct ChartCopy
{
    int chart = 0;
    bool mirrored = false;   //!< it matches only as a mirror image
    std::vector<int> corner; //!< of its faces, ascending
    std::vector<int> source; //!< the matching corners of the original
};

//! A chart and its copies.
struct AlikeCharts
{
    int original = 0;
    std::vector<ChartCopy> copies; //!< in the order in which the charts were given
};

//! Sorts charts by what they are copies of. A copy has the same polygons, connected in the same way, with the
//! same 3D side lengths, to within 1e-4 of the longest. \param candidates the charts to look at; the first
//! one of each kind is the original \returns kinds with copies only
std::vector<AlikeCharts> findAlikeCharts(const MeshData &mesh, const MeshAdjacency &adjacency,
                                         const ChartMap &charts, const std::vector<int> &candidates);

} // namespace autocuts
