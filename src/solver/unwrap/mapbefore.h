// The map before a job as a map to start from.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/search/cutstate.h"

#include <memory>
#include <optional>

namespace autocuts::unwrap {

//! The snapshot's map, in solver units, with the user's cuts; nothing when there is none, when it has flipped
//! triangles, or when it does not obey the joins.
//! \param openJoins joined edges may be seams
[[nodiscard]] std::optional<SeamedMap> mapBefore(const Soup &soup, const Snapshot &snapshot,
                                                 bool openJoins = false);

//! The snapshot's map, changed where the steering asks for it: cuts opened, joins closed, hard pins reached.
//! Overlaps are cut apart, and islands that no pins hold get one density.
//! \param graph of the snapshot
//! \returns nothing when there is no map, when it has flipped triangles, when the joins cannot be closed, or
//! when stopped
[[nodiscard]] std::optional<search::CutState>
steeredMapBefore(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                 const JobContext &job = {});

} // namespace autocuts::unwrap
