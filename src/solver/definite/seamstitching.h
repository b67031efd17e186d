// Stitches seams of a definite map at once, without a solve.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/seamsewing.h"

#include <map>
#include <vector>

namespace autocuts::definite {

//! A map after stitching.
struct StitchedMap
{
    UvMatrix uv;                       //!< one row per corner, texture space
    std::vector<int> edges;            //!< the edge pairs that are closed now, ascending
    std::map<SewOutcome, int> refused; //!< how many seam edges stayed open, by what prevented it
};

//! Closes the given seams in the map of the snapshot. Between two islands the smaller one in the map, or the
//! one that is neither locked nor pinned hard, moves, turns and scales to the other one (and is turned over
//! when it is mirrored) and the sides become the same, bit for bit; inside one island the seam is zipped.
//! Where that would flip triangles or make an island overlap itself, the faces around the seam are relaxed;
//! where it still would, the seam stays as it was. Seams of these islands that are not given stay open.
//! \param edges edges of MeshAdjacency; those that are no seams are left out
//! \pre snapshot.uv is not null
StitchedMap stitchSeams(const Snapshot &snapshot, const std::vector<int> &edges, const JobContext &job = {});

} // namespace autocuts::definite
