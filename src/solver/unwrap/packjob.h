// The job "pack" of the window and the command line.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/islandflags.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/packing.h"

namespace autocuts::unwrap {

//! What to pack, and how.
struct PackJob
{
    packing::PackOptions options{};       //!< settings and bin
    std::vector<IslandFlags> faceFlags{}; //!< per face; empty: none is locked, stacked or grouped
    std::vector<bool> movable{};          //!< per face; charts without such a face are obstacles; empty: all
    bool hurryWhenStopped = false;        //!< when stopped before the first layout, still make a quick one
};

//! Packs charts around locked ones; the charts of a stack or group move as one island.
//! \param uv per corner, texture space; changed only when the result is true
//! \returns false when there is no room, or when stopped before there was a layout
[[nodiscard]] bool packCharts(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, UvMatrix &uv,
                              const JobContext &job = {});

} // namespace autocuts::unwrap
