// Joins parts again after a separation.
#pragma once

#include "solver/overlap/unitgraph.h"

#include <cstdint>
#include <vector>

namespace autocuts::overlap {

//! Joins parts where that creates no overlap, the costliest common seam first, and straightens the seams
//! between the rest, so that few parts and short seams remain. Only parts that share a link are joined.
//! \param capacity per link of the graph, cost of cutting it, at least 1
//! \param part the part of each unit
void joinCleanParts(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                    std::vector<int> &part);

} // namespace autocuts::overlap
