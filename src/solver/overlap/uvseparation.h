// Separates the overlaps of a map with the user's steering.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/overlap/overlapseparation.h"

namespace autocuts::overlap {

//! A map whose charts do not overlap themselves. They stay where they were.
struct [[nodiscard]] Separated
{
    ChartMap charts;
    int newSeams = 0;        //!< edges cut
    int unresolvedPairs = 0; //!< overlapping pairs inside single polygons and joined groups of them
    bool complete = true;    //!< false when cancelled: then nothing was cut
};

//! separateOverlaps() with the user's steering: edges that the user joined are not cut, and the painted
//! weights scale the cost of the others.
//! \param soupUv,cut see separateOverlaps()
//! \throws std::invalid_argument when a size does not fit the mesh
SeparationResult separateSteered(const Snapshot &snapshot, const UvMatrix &soupUv,
                                 const std::vector<bool> &cut, const JobContext &job = {},
                                 SeparationMethod method = SeparationMethod::MinCut);

//! The same for the UVs of a document or file, whose seams are where the two sides differ.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
Separated separateUv(const Snapshot &snapshot, const UvMatrix &uv, const JobContext &job = {},
                     SeparationMethod method = SeparationMethod::MinCut);

} // namespace autocuts::overlap
