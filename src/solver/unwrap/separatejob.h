// Taking overlaps apart as the window and the command line do it.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/unwrap/packjob.h"

namespace autocuts::unwrap {

struct SeparateResult
{
    enum class Outcome {
        Done,
        NoOverlaps, //!< the map stays as it is
        Stopped,    //!< the map stays as it is
        NoRoom      //!< the map stays as it is: the pieces cannot be packed
    };
    Outcome outcome = Outcome::Done;
    UvMatrix uv;             //!< per corner, texture space
    int newSeams = 0;        //!< edges cut
    int unresolvedPairs = 0; //!< overlaps inside single polygons or across joined edges, which stay whole
};

//! Cuts charts that cover themselves, not along joined edges and rather where the weights are low, and packs.
//! \param uv per corner, texture space; a non-finite row means that the corner has no UV
[[nodiscard]] SeparateResult separateMap(const Snapshot &snapshot, const UvMatrix &uv, const PackJob &pack,
                                         const JobContext &job = {});

} // namespace autocuts::unwrap
