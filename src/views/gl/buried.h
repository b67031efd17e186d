// What need not be drawn of a map that covers itself many times.
#pragma once

#include "views/gl/soupbuffers.h"

namespace autocuts {

//! Layers of the map that are drawn of those on top of each other. Of what lies below, a filled map shows
//! less than a hundredth. Chosen by hand.
inline constexpr int drawnLayers = 8;

//! Gives triangles the mark Buried that lie below that many others wherever they are sampled, on a grid over
//! the map. Only for maps that cover themselves more often than that on average: textures that repeat over
//! hundreds of tiles would otherwise take seconds to draw. \param soupUv one row per soup corner
void markBuried(const UvMatrix &soupUv, std::vector<FaceTexel> &texels);

} // namespace autocuts
