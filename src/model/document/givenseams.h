// Finds the seams that the user gives to a job.
#pragma once

#include "model/document/changeevent.h"
#include "model/document/scene.h"
#include "model/plain/snapshot.h"

#include <span>

namespace autocuts {

//! The edges at which the user wants seams, from all sources in the options. As everywhere, an edge counts as
//! cut when one of its ends is cut, and as joined when one of its ends is joined and none is cut. Joined
//! edges are not among the given seams, nor are diagonals. A seam of the map is an edge of two polygons with
//! UVs. \param uv the map that is there, one row per corner; null for none \param states per corner pair;
//! empty when all are free \returns one entry per edge pair
std::vector<bool> givenSeams(const Scene &scene, const UvMatrix *uv, std::span<const PairState> states,
                             const GivenSeamOptions &options);

//! True when the given seams of a document may be others after this event.
bool changesGivenSeams(const ChangeEvent &event);

} // namespace autocuts
