// Packing the charts of a map: the one way that the window and the command line go.
#pragma once

#include "model/plain/chart.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/packing.h"

namespace autocuts::packing {

//! Gives the charts one texel density unless their scale is to be kept, packs them and moves their UVs.
//! \param uv one row per corner, UV units; stays as it is unless the result is complete
//! \param locked per chart: obstacles; empty: none
PackResult packMap(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &locked,
                   const PackOptions &settings, UvMatrix &uv, const JobContext &job = {});

//! Options that pack into the UDIM tile of the settings: 1001 is the unit square, ten in a row.
PackOptions tileOptions(const PackingSettings &settings);

} // namespace autocuts::packing
