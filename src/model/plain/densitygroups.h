// Which islands of a map have one texel density on purpose. Plain: no Qt.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! The islands of a map by texel density. Tiles may differ, and the user may scale islands: the islands of a
//! tile whose density differs by less than 2.5 % from the median one of the tile are a group, and every other
//! island is one by itself. Without tiles, see TileLayout::hasTiles, all islands count as of one.
struct DensityGroups
{
    std::vector<int> ofChart;    //!< per chart: its group; -1: it has no area
    std::vector<double> density; //!< per group: length in UV units for a length on the model, by the areas
};

//! \param charts of the UVs
DensityGroups densityGroups(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                            double tileHeight);

} // namespace autocuts
