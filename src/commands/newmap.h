// A whole new map for the active UV set: unwrapped, finished, packed.
#pragma once

#include "commands/setuvs.h"

namespace autocuts {

//! The command that puts the map into the document. The scale of the set becomes the map's
//! (DocumentState::uvScales), and pins go to where their corners are then.
//! \param uv one row per corner, texture space
//! \param count for the text in the history; none: the islands of the map
std::unique_ptr<SetUvs> newMapCommand(Document &document, UvEdit edit, const UvMatrix &uv,
                                      std::optional<int> count = std::nullopt);

} // namespace autocuts
