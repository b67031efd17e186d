// Puts the islands of a new map where they were in the map before.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/packingsettings.h"

#include <vector>

namespace autocuts::unwrap {

//! The map before the job, with its charts.
struct OldPlaces
{
    const UvMatrix &uv; //!< per corner, texture space
    const ChartMap &charts;
};

//! Moves every chart that is not held onto the place of the old chart that it has most in common with. A
//! chart without one is put far away, so that it counts as outside of its bin.
//! \param held per chart; empty: none \param turns how charts may be turned to where they were
//! \param uv the new map: per corner, texture space
[[nodiscard]] UvMatrix atOldPlaces(const MeshData &mesh, const ChartMap &charts,
                                   const std::vector<bool> &held, const OldPlaces &before, PackRotation turns,
                                   const UvMatrix &uv);

} // namespace autocuts::unwrap
