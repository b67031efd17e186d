// Maps of rigid regions that the seam search starts from.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/search/seamgraph.h"
#include "solver/search/seamrun.h"

#include <vector>

namespace autocuts::unwrap {

//! Maps in which the rigid regions of a problem are joined to nets without stretch. The rest of the surface
//! is cut off them and has first cuts of the seam search. \param count how many; fewer when stopped, none
//! when the problem has no rigid regions
[[nodiscard]] std::vector<SeamedMap> netStarts(const std::shared_ptr<const search::SeamGraph> &graph,
                                               const Snapshot &snapshot, int count, const JobContext &job);

//! True when nets of rigid regions are nearer to the end than maps with few cuts, and than the soup.
[[nodiscard]] bool startsFromNets(const Snapshot &snapshot);

//! Adds maps of nets to those that a search starts from. Where most is rigid they take the place of others.
void addNetStarts(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                  const JobContext &job, search::OptimizeOptions &search);

} // namespace autocuts::unwrap
