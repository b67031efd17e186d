// The figures of a map's UDIM tiles.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshdata.h"
#include "model/plain/uvfigures.h"

namespace autocuts::metrics {

//! Fills in what UvMetrics says of tiles: packing and distances to their borders.
//! \param charts of the UVs, one row per corner \param tileHeight see PackingSettings::tileHeight()
//! \param covers per chart: its area counts as covered \pre coveredArea is set
void measureTiles(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts,
                  const std::vector<bool> &covers, double tileHeight, UvMetrics &metrics);

} // namespace autocuts::metrics
