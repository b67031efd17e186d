// Finds islands that are copies of each other, such as those of repeated bolts or wheels.
#pragma once

#include "model/plain/meshadjacency.h"

#include <vector>

namespace autocuts {

class Islands;

//! What two similar islands have in common.
enum class Similarity {
    Topology, //!< the same polygons, connected in the same way
    Shape     //!< in addition the same 3D side lengths, to within 1e-4 of the longest
};

//! The islands similar to the given one, including itself, in ascending order. Mirrored copies are similar.
//! The comparison uses invariants (refined neighbourhood colours, sorted side lengths): all copies are found;
//! different islands are mistaken for copies only in contrived cases.
std::vector<int> similarIslands(const MeshData &mesh, const MeshAdjacency &adjacency, const Islands &islands,
                                int island, Similarity similarity);

} // namespace autocuts
