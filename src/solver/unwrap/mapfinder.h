// Finds the map of an unwrap: by way of a coarser mesh, of one part of each kind, or as it is. Charts are
// placed elsewhere.
#pragma once

#include "solver/unwrap/candidates.h"

namespace autocuts::unwrap {

//! A map that is not placed yet.
struct FoundMap
{
    Candidate best;
    int iterations = 0;
    std::optional<double> symmetry; //!< as UnwrapResult::symmetry
    bool symmetryMissed = false;    //!< the same
    bool onlyReady = false;         //!< stopped before there was a map; the result is ready
};

//! The map that can be made at once. \param given the problem of a FreePart
[[nodiscard]] Candidate patchesOf(const Snapshot &given);

//! Finds the best map. \param given the problem of a FreePart \param prepare gets the maps that are found on
//! the way; the map may then be missing after a stop, see FoundMap::onlyReady
[[nodiscard]] FoundMap findMap(const Snapshot &given, const UnwrapOptions &options, Ranking &ranking,
                               const JobContext &job, const PrepareMap &prepare = {});

} // namespace autocuts::unwrap
