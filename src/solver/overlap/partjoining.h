// Puts pieces together again after a separation.
#pragma once

#include "solver/overlap/unitgraph.h"

#include <cstdint>
#include <vector>

namespace autocuts::overlap {

//! Joins parts again where that makes no overlap, the longest common seam first, and straightens the seams
//! between them, so that few pieces and short seams remain. Only parts that are linked are joined.
//! \param capacity per link of the graph, cost of cutting it, at least 1
//! \param part label of each unit
void joinCleanParts(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                    std::vector<int> &part);

} // namespace autocuts::overlap
