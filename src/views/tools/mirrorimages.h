// Finds the edges and faces of a model that are mirror images of each other.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! For every edge pair, the edge pair at its mirror image in the plane x = 0; -1 when there is none, and for
//! diagonals. Edges on the plane are their own images. Midpoints match when the distance from the mirror
//! image is at most a quarter of the edge's length; chosen by hand.
std::vector<int> mirroredEdges(const MeshData &mesh);
//! The same for faces: the centres of their corners match within a quarter of the square root of their area.
std::vector<int> mirroredFaces(const MeshData &mesh);

} // namespace autocuts
