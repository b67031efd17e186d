// Distance between the borders of different charts. Internal to the metrics.
#pragma once

#include "model/plain/chart.h"

namespace autocuts::metrics {

//! Smallest UV distance between open edges (seams and borders) of two different charts; 0 when they cross,
//! infinite when there is only one chart. Charts of one stack count as one.
//! \param uv one row per corner
//! \param stacks number of the stack of each chart; 0: none
double smallestGutter(const UvMatrix &uv, const UvTopology &topology, const std::vector<int> &stacks);

} // namespace autocuts::metrics
