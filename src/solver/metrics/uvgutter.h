// Distance between the borders of different charts. Internal to the metrics.
#pragma once

#include "model/plain/chart.h"

namespace autocuts::metrics {

//! Smallest UV distance between open edges (seams and borders) of two different charts; 0 when they cross,
//! infinite when there is only one chart.
//! \param uv one row per corner
double smallestGutter(const UvMatrix &uv, const UvTopology &topology);

} // namespace autocuts::metrics
