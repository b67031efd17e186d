// A model of separate parts, each an island, for tests of laying out islands.
#pragma once

#include "support/editsupport.h"

namespace autocuts::test {

//! How one part lies in the map.
struct PartPlace
{
    Vec2 move = Vec2::Zero();
    double angle = 0; //!< radians
    double scale = 1;
    bool mirrored = false; //!< the part itself in 3D, not its UVs
};

//! One L of three quads for each place, with arms of different lengths (boxes of 2.5 x 2 units before they
//! are turned), without stretch in the map. Its UVs are a tenth of its size.
std::unique_ptr<Document> partsDocument(const std::vector<PartPlace> &places);
//! The number of faces, and of corners, of one part.
inline constexpr int partFaces = 3, partCorners = 12;

} // namespace autocuts::test
