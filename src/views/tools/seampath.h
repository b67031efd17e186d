// Finds paths along edges between two clicks.
#pragma once

#include "views/canvas/picking.h"

#include <vector>

namespace autocuts {

class Document;

//! An end of a path along edges: a vertex or an edge; the other one is -1.
struct PathEnd
{
    int vertex = -1; //!< welded
    int edge = -1;   //!< edge of MeshAdjacency

    bool isNone() const { return vertex < 0 && edge < 0; }
    bool operator==(const PathEnd &) const = default;
};

//! The vertex near the mouse, or else the edge.
PathEnd pathEnd(const Document &document, const PickResult &pick);

//! Factors for shortestPath(), by which paths do not run through hidden faces; empty when none are hidden.
std::vector<double> shownEdgeFactors(const Document &document);

//! The edges of the shortest path that is seen, including edges at its ends, in ascending order; empty when
//! there is no path or an end is missing.
std::vector<int> pathBetween(const Document &document, const PathEnd &from, const PathEnd &to);

} // namespace autocuts
