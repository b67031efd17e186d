// The first map of a surface of many handles and borders.
#pragma once

#include "solver/search/seamrun.h"

#include <memory>
#include <optional>

namespace autocuts::search {

//! A map of clusters, see clusterSeams(): those that are badly distorted, or have no map at all, are divided
//! further. \param whole regions that are not divided; null: none \returns nothing when that needs many
//! charts that are too small, or when the job was stopped
[[nodiscard]] std::optional<CutState> firstClusters(const std::shared_ptr<const SeamGraph> &graph,
                                                    const OptimizeOptions &options,
                                                    const RigidRegions *whole = nullptr);

} // namespace autocuts::search
