// Ways along edges between two clicks.
#pragma once

#include "views/canvas/picking.h"

#include <vector>

namespace autocuts {

class Document;

//! Where a way along edges begins or ends: at a vertex, or with an edge. -1 for what it is not.
struct PathEnd
{
    int vertex = -1; //!< welded
    int edge = -1;   //!< of MeshAdjacency

    bool isNone() const { return vertex < 0 && edge < 0; }
    bool operator==(const PathEnd &) const = default;
};

//! The vertex near the mouse, or else the edge.
PathEnd pathEnd(const Document &document, const PickResult &pick);

//! The edges of the shortest way, with those that it begins and ends with, in rising order; empty when there
//! is no way or an end is none.
std::vector<int> pathBetween(const Document &document, const PathEnd &from, const PathEnd &to);

} // namespace autocuts
