// Overlap separation of a map as it stands in a file.
#pragma once

#include "model/plain/chart.h"

#include <atomic>

namespace autocuts::overlap {

//! Charts free of overlaps inside themselves; they still lie where they were.
struct Separated
{
    ChartMap charts;
    int newSeams = 0;        //!< edges cut
    int unresolvedPairs = 0; //!< overlaps inside single polygons
    bool complete = true;    //!< false when cancelled: then nothing was cut
};

//! Cuts the charts of a map that cover themselves. \param uv one row per corner; a non-finite row means that
//! the corner has no UV
Separated separateUv(const MeshData &mesh, const UvMatrix &uv, const std::atomic<bool> *cancel = nullptr);

} // namespace autocuts::overlap
