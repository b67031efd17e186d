// Where a definite map tears when it is pulled too far.
#pragma once

#include "model/plain/types.h"

#include <optional>
#include <vector>

namespace autocuts {

class Document;

//! What comes off an island.
struct TornPart
{
    std::vector<int> edges;       //!< edge pairs that open, ascending
    std::vector<int> soupCorners; //!< of the faces that come off, ascending
};

//! The part around a hand that comes off by the shortest seam: faces near the hand come off, faces far away
//! stay. Joined edges never tear. \param separation per corner pair, from 0 (closed) to 1 (cut)
//! \param follows per soup corner how far it follows the hand: 1 in the hand, 0 where it stays
//! \returns nothing when all of the island follows or joined edges hold it
std::optional<TornPart> tornPart(const Document &document, const std::vector<float> &separation,
                                 const std::vector<double> &follows);

//! How much the most deformed triangle is stretched or squeezed in one direction: 1 not at all, infinite when
//! it is turned over. Triangles without area or UVs before are ignored.
//! \param before, now one row per soup corner
//! \param soupCorners of the triangles, ascending
double strainOf(const UvMatrix &before, const UvMatrix &now, const std::vector<int> &soupCorners);

} // namespace autocuts
