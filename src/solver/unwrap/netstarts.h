// Maps of rigid regions that the seam search starts from.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/search/seamgraph.h"
#include "solver/search/seamrun.h"

namespace autocuts::unwrap {

//! True when nets of rigid regions are nearer to the end than maps with few cuts, and than the soup.
[[nodiscard]] bool startsFromNets(const Snapshot &snapshot);

//! The map of a draft: clusters of the curved surface and the rigid regions, joined to nets. Takes the place
//! of all first maps of the search. \returns false when there is none
[[nodiscard]] bool startFromClusterNets(const std::shared_ptr<const search::SeamGraph> &graph,
                                        const Snapshot &snapshot, search::OptimizeOptions &search);

//! Adds maps to those that a search starts from, in which the rigid regions of the problem are joined to nets
//! without stretch. Where most is rigid they take the place of others.
void addNetStarts(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                  const JobContext &job, search::OptimizeOptions &search);

} // namespace autocuts::unwrap
