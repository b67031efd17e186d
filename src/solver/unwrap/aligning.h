// The job "align to the axes" of the window, for chosen islands of a map.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/packing.h"

namespace autocuts::unwrap {

struct AlignInput
{
    Snapshot snapshot{};            //!< with the map; the scope, which is needed, has the islands
    double maxDistortion = 4.1;     //!< bound on the mean symmetric Dirichlet energy, > 4
    packing::PackOptions packing{}; //!< used for islands that come to lie on others
};

struct AlignResult
{
    UvMatrix uv;              //!< per corner, texture space; no rows when the map stays
    double before = 0;        //!< mean symmetric Dirichlet energy of the islands, each at its own scale
    double after = 0;         //!< the same of the result
    bool nothingFree = false; //!< locks or pins leave nothing to change
    bool flipped = false;     //!< nothing was done because triangles of the islands are flipped
    bool madeSmaller = false; //!< the islands of some tiles were packed anew, all smaller, to make room
    bool noRoom = false;      //!< islands lie on others now, because there is no room for them
};

//! Turns the islands of the scope to the axes and makes straight what is straight on the model, as far as the
//! bound allows, or a little more distortion than before where that is above it. The seams, the sizes and,
//! where nothing would overlap, the places of the islands stay. Islands with pins stay as they are.
[[nodiscard]] AlignResult alignIslands(const AlignInput &input, const JobContext &job = {});

} // namespace autocuts::unwrap
