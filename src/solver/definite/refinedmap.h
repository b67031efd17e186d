// Makes a refined map from a live solve: the definite map, improved by the seam search.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/definite/definitemap.h"
#include "solver/search/seamgraph.h"

namespace autocuts::definite {

struct RefinedMap
{
    SeamedMap map;
    int anchorFaults = 0; //!< see search::CutState
};

//! Moves and shortens the seams of a map by the seam search, and adds some where the bound requires it.
//! Charts that hard pins hold are put exactly there; the others stay about where their triangles were.
//! Different charts may overlap. When the job is stopped, the best map so far is returned.
//! \param graph of the snapshot
//! \param places per soup corner: where it was, solver units
//! \param maxDistortion bound on the mean distortion, > 4
[[nodiscard]] RefinedMap refineMap(const std::shared_ptr<const search::SeamGraph> &graph,
                                   const Snapshot &snapshot, RefinedMap made,
                                   const std::vector<double> &places, double maxDistortion,
                                   const JobContext &job = {});
//! makeDefiniteMap() followed by refineMap().
//! \returns nothing when stopped before there was a map
[[nodiscard]] std::optional<RefinedMap> makeRefinedMap(const homotopy::Solver &solver, double maxDistortion,
                                                       const JobContext &job = {});

} // namespace autocuts::definite
