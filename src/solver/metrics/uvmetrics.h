// Measures a UV map for tools and reports.
#pragma once

#include "model/plain/islandflags.h"
#include "model/plain/meshdata.h"
#include "model/plain/uvfigures.h"
#include "solver/base/jobcontext.h"

namespace autocuts::metrics {

//! Which figures are measured, and the size of the texture.
struct UvMetricsOptions
{
    int textureSize = 2048; //!< texels along the width of the texture, for figures in texels
    double tileHeight = 1;  //!< of the texture, see PackingSettings::tileHeight()
    bool overlaps = true;   //!< false: the overlap figures stay missing
    bool gutter = true;     //!< false: the distances between charts stay missing
    //! Per face. Islands of one stack neither overlap nor have gutters. Empty: none is stacked.
    std::vector<IslandFlags> faceFlags{};
    JobContext job; //!< may stop the overlap test, whose figures are then missing
};

//! Measures all figures of a map.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \throws std::invalid_argument when uv does not have one row per corner
UvMetrics measureUv(const MeshData &mesh, const UvMatrix &uv, const UvMetricsOptions &options = {});

//! The same without what takes long: overlaps and distances between charts.
UvMetrics measureShapes(const MeshData &mesh, const UvMatrix &uv, double tileHeight);

} // namespace autocuts::metrics
