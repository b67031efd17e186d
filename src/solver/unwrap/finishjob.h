// Finishing as the window and the command line do it: from a half-solved map to one that can be used.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/unwrap/packjob.h"

#include <optional>

namespace autocuts::unwrap {

//! Where a live solve was paused.
struct LiveState
{
    std::vector<double> coordinates; //!< of the soup, see Soup
    double lambda = 0, delta = 0;
    bool hasMoreToDo = false; //!< paused before the schedule came to its end
};

struct FinishInput
{
    Snapshot snapshot;
    UvMatrix uv;                   //!< per corner, texture space: the map to finish without a live solve
    double uvScale = 1;            //!< texture space per solver unit
    std::optional<LiveState> live; //!< that the map was made from
    double maxDistortion = 4.1;    //!< bound on the mean distortion, > 4
    packing::PackOptions packing;  //!< used when islands come to lie over each other
};

struct FinishResult
{
    UvMatrix uv;           //!< per corner, texture space; no rows: stopped before there was a map
    double distortion = 0; //!< mean symmetric Dirichlet energy
    bool noRoom = false;   //!< islands lie over each other and there is no room to pack them
    //! The map covers itself all the same: joined edges hold it together there.
    bool heldTogether = false;
};

//! Takes a live solve that was paused early to its end, makes a definite map of it, refines its seams, and
//! packs when islands lie over each other or outside the unit square, unless pins or rectangles place them.
//! Without a live solve the seams are those of the map.
[[nodiscard]] FinishResult finishMap(const FinishInput &input, const JobContext &job = {});

} // namespace autocuts::unwrap
