// Finding islands that are copies of each other: repeated bolts, wheels, windows.
#pragma once

#include "model/plain/meshadjacency.h"

#include <vector>

namespace autocuts {

class Islands;

//! What copies have in common.
enum class Similarity {
    Topology, //!< the same polygons, neighboured in the same way
    Shape     //!< besides, the same lengths of sides in 3D, to within 1e-4 of the longest
};

//! The islands similar to the given one, itself included, in rising order. Mirrored copies are similar. The
//! comparison is by invariants (refined neighbourhood colours, sorted side lengths): copies are always found,
//! and islands that differ are told apart in all but contrived cases.
std::vector<int> similarIslands(const MeshData &mesh, const MeshAdjacency &adjacency, const Islands &islands,
                                int island, Similarity similarity);

//! For every corner of island `to`, in the order of Islands::corners(), the corner of island `from` in its
//! place, when `to` is a copy of `from` that is moved and turned but not mirrored: the same polygons with the
//! same lengths, to within 1e-4 of the longest. Empty when it is not.
std::vector<int> copiedCorners(const MeshData &mesh, const MeshAdjacency &adjacency, const Islands &islands,
                               int from, int to);

} // namespace autocuts
