// Distortion figures of a UV map. Internal to the metrics.
#pragma once

#include "model/plain/densitygroups.h"
#include "model/plain/uvfigures.h"
#include "solver/metrics/uvtriangles.h"

namespace autocuts::metrics {

//! Fills flips, symmetric Dirichlet, stretch, angle and area distortion, and the figures per triangle.
//! \param groups of the charts
void measureDistortion(const MeshData &mesh, const UvMatrix &uv, const UvTriangles &triangles,
                       const DensityGroups &groups, UvMetrics &metrics);

} // namespace autocuts::metrics
