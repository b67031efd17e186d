// Packs the charts of a UV map; used by the window and by the command line.
#pragma once

#include "model/plain/chart.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/islandgeometry.h"

namespace autocuts::packing {

//! Gives the charts one texel density (unless settings.keepScale), packs them and moves their UVs.
//! \param locked per chart: it keeps its place as an obstacle; empty: none
//! \param upright per chart: it is not turned; empty: none
//! \param uv one row per corner, UV units; changed only when the result is complete
//! \param basis of the texel density
PackResult packMap(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &locked,
                   const std::vector<bool> &upright, const PackOptions &settings, DensityBasis basis,
                   UvMatrix &uv, const JobContext &job = {});

//! Options for packing into the UDIM tile of the settings: 1001 is the first, ten tiles make a row.
PackOptions tileOptions(const PackingSettings &settings);

} // namespace autocuts::packing
