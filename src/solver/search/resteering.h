// Takes a map to other cuts, joins and pins, and leaves the rest of it as it is.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/search/cutstate.h"

#include <memory>
#include <optional>

namespace autocuts::search {

//! Adapts a map to a graph of the same mesh with other steering: opens what has to be cut, closes what was
//! joined, and takes charts to pins. Where closing an edge would make charts overlap, the
//! triangles next to it are cut off their chart.
//! \returns nothing when an edge could not be closed, or when stopped
[[nodiscard]] std::optional<CutState> resteered(const CutState &map, std::shared_ptr<const SeamGraph> graph,
                                                const JobContext &job = {});

} // namespace autocuts::search
