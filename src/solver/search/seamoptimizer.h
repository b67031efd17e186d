// The automatic cutter: finds short seams within a bound on the distortion.
#pragma once

#include "solver/search/seamrun.h"

namespace autocuts::search {

struct OptimizedMap
{
    SeamedMap map;
    double mu = 0;        //!< energy that one unit of seam cost was worth at the end
    int iterations = 0;   //!< Newton steps of all runs, on patches of all sizes
    int anchorFaults = 0; //!< see CutState
};

//! The map with no other cuts than the user's, relaxed; nothing when a chart is closed or the map misses the
//! bound.
[[nodiscard]] std::optional<OptimizedMap> flatMap(const std::shared_ptr<const SeamGraph> &graph,
                                                  const OptimizeOptions &options);

//! First cuts and their map. \param number every number gives other cuts
//! \returns nothing when all tries have flipped triangles, or overlaps that are not allowed
[[nodiscard]] std::optional<CutState> firstMap(const std::shared_ptr<const SeamGraph> &graph,
                                               const OptimizeOptions &options, int number);

//! Searches for the shortest seams within the bound. The same arguments give the same bits unless the job is
//! stopped. \returns the best map found, above the bound when no map met it; nothing when no first map
//! without flipped triangles (or without overlaps, where these are not allowed) was found, or when the job
//! was stopped before
[[nodiscard]] std::optional<OptimizedMap> optimizeSeams(const std::shared_ptr<const SeamGraph> &graph,
                                                        const OptimizeOptions &options);

} // namespace autocuts::search
