// The job "lightmap" of the window and the command line.
#pragma once

#include "solver/unwrap/separatejob.h"

namespace autocuts::unwrap {

//! Makes a map for lightmaps from another map: its islands keep their shapes as far as they do not cover
//! themselves, get one texel density and places of their own. Where the snapshot keeps tiles, they stay in
//! theirs. Nothing of the steering counts, so that stacks are taken apart and locked islands move.
//! \param snapshot with the map; rows that are not finite: the corner has no UV
//! \returns never NoOverlaps or NothingFree
[[nodiscard]] SeparateResult makeLightmap(const Snapshot &snapshot, const packing::PackOptions &options,
                                          const JobContext &job = {});

} // namespace autocuts::unwrap
