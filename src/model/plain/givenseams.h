// Finds the seams that the user gives to a job. Plain: no Qt.
#pragma once

#include "model/plain/snapshot.h"

#include <span>

namespace autocuts {

//! Where given seams may come from.
struct SeamSources
{
    const MeshData &mesh;
    const UvMatrix *uv = nullptr;         //!< the map that is there, one row per corner; null for none
    std::span<const PairState> states;    //!< per corner pair; empty when all are free
    const std::vector<bool> &hardEdges;   //!< per edge pair; empty when nothing is known
    const std::vector<int> &faceMaterial; //!< per face; empty: none has one
};

//! The edges at which the user wants seams, from all sources in the options. As everywhere, an edge counts as
//! cut when one of its ends is cut, and as joined when one of its ends is joined and none is cut. Joined
//! edges are not among the given seams, nor are diagonals. A seam of the map is an edge of two polygons with
//! UVs. \returns one entry per edge pair
std::vector<bool> givenSeams(const SeamSources &sources, const GivenSeamOptions &options);

} // namespace autocuts
