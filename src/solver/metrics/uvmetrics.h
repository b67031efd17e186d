// The figures that describe a UV map, as tools and reports compare them.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"
#include "solver/metrics/uvfigures.h"

#include <atomic>

namespace autocuts::metrics {

//! What to measure.
struct UvMetricsOptions
{
    int textureSize = 2048; //!< for figures in texels: texels along a side of the unit square
    bool overlaps = true;   //!< false: the overlap figures stay missing
    bool gutter = true;     //!< false: the distances between charts stay missing
    JobContext job;         //!< stops the overlap test, whose figures then are missing
};

//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \throws std::invalid_argument when uv does not have one row per corner
UvMetrics measureUv(const MeshData &mesh, const UvMatrix &uv, const UvMetricsOptions &options = {});

} // namespace autocuts::metrics
