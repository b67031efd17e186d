// Packing as the window and the command line do it.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/islandflags.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/packing.h"

namespace autocuts::unwrap {

struct PackJob
{
    packing::PackOptions options;       //!< and the bin
    std::vector<IslandFlags> faceFlags; //!< one per face; empty: none is locked, stacked or grouped
    std::vector<bool> movable;          //!< per face; the charts of the others are obstacles; empty: all
    bool hurryWhenStopped = false;      //!< stopped before there is a layout: make a quick one all the same
};

//! Packs charts: stacks and groups as one piece, around locked charts.
//! \param uv per corner, texture space; changed only when the result is true
//! \returns false when there is no room, or when stopped before there was a layout
[[nodiscard]] bool packCharts(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, UvMatrix &uv,
                              const JobContext &job = {});

} // namespace autocuts::unwrap
