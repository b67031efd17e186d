// A mesh cut open along seams: which corners share a UV vertex, and which triangles a chart.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! One flag per edge pair: true where the two sides are apart. Diagonals are never cut.
using CutFlags = std::vector<bool>;

//! The topology that cut flags give. Derived; rebuilt when the flags change.
struct CutMesh
{
    std::vector<int> uvVertex; //!< per soup corner; the corners of one fan of triangles share one
    int uvVertexCount = 0;
    std::vector<int> chart; //!< per triangle
    int chartCount = 0;
    std::vector<int> neighbour; //!< per triangle side 3 t + k: soup side across it, -1 at a seam or border

    CutMesh() = default;
    CutMesh(const MeshData &mesh, const CutFlags &cut);

    //! Boundary loops of every chart as soup sides (3 t + k) in order, the chart on their left.
    std::vector<std::vector<int>> boundaryLoops() const;
};

//! Uncuts what is cut without effect: edges whose two sides share their UV vertices at both ends.
//! Repeats until nothing changes.
void dropClosedCuts(const MeshData &mesh, CutFlags &cut);

//! Cuts that open every component to a topological disk (none where it is one already): the edges off a
//! breadth-first tree of the triangles, with loose ends pruned. A closed sphere gets a cut of two edges or
//! more. Works for any genus and any number of borders. \param cut what is cut already; it stays cut
CutFlags cutToDisks(const MeshData &mesh, const CutFlags &cut = {});

} // namespace autocuts
