// Topology of a mesh that is cut open along seams: its UV vertices and charts.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! One flag per edge pair: true where the edge is cut, so that its two sides may differ in UV. Diagonals are
//! never cut.
using CutFlags = std::vector<bool>;

//! UV vertices and charts that follow from cut flags. A chart is a connected set of triangles over uncut
//! edges. Keeps no reference to the flags: build it again when they change.
struct CutMesh
{
    //! Per soup corner. The corners of one fan of triangles over uncut edges share a UV vertex.
    std::vector<int> uvVertex;
    int uvVertexCount = 0;
    std::vector<int> chart; //!< per triangle
    int chartCount = 0;
    std::vector<int> neighbour; //!< per triangle side 3 t + k: the side across it, -1 at a seam or border

    CutMesh() = default;
    CutMesh(const MeshData &mesh, const CutFlags &cut);

    //! Boundary loops of all charts. Each lists triangle sides (3 t + k) in order, with the chart on the
    //! left.
    std::vector<std::vector<int>> boundaryLoops() const;
};

//! Clears the flags of cut edges whose two sides share their UV vertices at both ends: such a cut separates
//! nothing. Repeats until no flag changes.
void dropClosedCuts(const MeshData &mesh, CutFlags &cut);

//! Cuts that open every component to a topological disk; none where it is one already. Cuts all edges that a
//! spanning tree over the triangles, grown breadth first, does not cross, then removes cuts from their loose
//! ends. A closed sphere keeps at least two cut edges. Works for any genus and any number of borders.
//! \param cut edges that are cut already; they stay cut
CutFlags cutToDisks(const MeshData &mesh, const CutFlags &cut = {});

} // namespace autocuts
