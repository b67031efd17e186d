// The job "separate overlaps" of the window and the command line.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/overlap/overlapseparation.h"
#include "solver/unwrap/packjob.h"

namespace autocuts::unwrap {

struct SeparateResult
{
    enum class Outcome {
        Done,
        NoOverlaps, //!< the map is unchanged
        Stopped,    //!< the map is unchanged
        NoRoom,     //!< the map is unchanged, because its charts cannot be packed after the cuts
        NothingFree //!< the map is unchanged: locks or the scope leave nothing to cut
    };
    Outcome outcome = Outcome::Done;
    UvMatrix uv;             //!< per corner, texture space
    int newSeams = 0;        //!< number of edges that were cut
    int unresolvedPairs = 0; //!< overlapping pairs within single polygons or held together by joined edges
};

//! Cuts charts that overlap themselves, preferably where painted weights are low and never along joined
//! edges, and packs the charts. With SeparationMethod::Greedy the weights do not count.
//! \param snapshot with the map; rows that are not finite: the corner has no UV
[[nodiscard]] SeparateResult
separateMap(const Snapshot &snapshot, const PackJob &pack, const JobContext &job = {},
            overlap::SeparationMethod method = overlap::SeparationMethod::MinCut);

} // namespace autocuts::unwrap
