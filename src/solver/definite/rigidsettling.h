// Makes rigid regions keep their shape in a map that was found: the last step of a search with such regions.
#pragma once

#include "solver/search/seamoptimizer.h"

namespace autocuts::definite {

//! Energy that one unit of seam cost is usually worth near a bound of 4.1, see SeamRun.
inline constexpr double usualMu = 0.15;

//! The map with rigid regions that give way to nothing but hard pins. Regions that the seams of the map do
//! not let lie flat are cut out and joined to the rest along hinges, see rigid::Nets::cutOut(); where the
//! rest then has more stretch than the bound allows, the search opens seams there. Maps with pins are only
//! relaxed, and no joined edge is cut. \param graph of the snapshot, without or with symmetry \param mu
//! energy that one unit of seam cost is worth \param options of the search that found the map; its seeds,
//! given maps and progress are not used \returns the map as it was when there are no rigid regions, when the
//! bound cannot be met, or when stopped
[[nodiscard]] SeamedMap settleRigidRegions(const std::shared_ptr<const search::SeamGraph> &graph,
                                           const Snapshot &snapshot, const search::OptimizeOptions &options,
                                           SeamedMap map, double mu = usualMu);

} // namespace autocuts::definite
