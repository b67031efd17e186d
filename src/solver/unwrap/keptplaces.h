// Keeps the islands of a layout where they are when they have got a new map.
#pragma once

#include "solver/unwrap/freepart.h"
#include "solver/unwrap/packjob.h"

namespace autocuts::unwrap {

//! The charts of a new map, which lie where the islands of the map before did.
struct NewCharts
{
    UvMatrix uv; //!< per corner, texture space, at the scales of the map before
    ChartMap charts;
    //! Islands of the map before that stayed, because there is no room for those of the new map.
    int notReplaced = 0;
};

//! Gives the charts places at their size without turning them. Those that fit where they are stay, others go
//! into free room of their tile. Where there is none, the islands of the map before stay that they would have
//! replaced, if that map was valid there and obeys the steering; a tile is packed anew if so much of the
//! seams is saved by that.
//! \param snapshot with the map before \param maxDistortion bound on the mean symmetric Dirichlet energy
//! \returns false when that is not possible, or when stopped; then nothing has changed
[[nodiscard]] bool keepPlaces(const Snapshot &snapshot, const FreePart &part, const PackJob &pack,
                              double maxDistortion, NewCharts &map, const JobContext &job = {});

} // namespace autocuts::unwrap
