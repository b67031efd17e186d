// The command that replaces the whole map of the active UV set, after unwrapping, finishing or packing.
#pragma once

#include "commands/setuvs.h"

namespace autocuts {

//! Makes the command for a map. The set gets the scale of the map (DocumentState::uvScales). Pins stay: jobs
//! obey them.
//! \param uv one row per corner, texture space
//! \param count number in the history's text; without it, the number of islands that the map changes
//! \param flags new flags of the islands, per face; empty: they stay
std::unique_ptr<SetUvs> newMapCommand(Document &document, UvEdit edit, const UvMatrix &uv,
                                      std::optional<int> count = std::nullopt,
                                      const std::vector<IslandFlags> &flags = {});

} // namespace autocuts
