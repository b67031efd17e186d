// What a seam search has to know about the mesh and never changes.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/csrlist.h"
#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"
#include "solver/preference/meshsymmetry.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace autocuts::search {

//! The edges as a graph that seams run along, and what the user wants of them. Immutable.
struct SeamGraph
{
    enum class Rule : std::uint8_t { Free, AlwaysCut, NeverCut };

    std::shared_ptr<const Soup> soup;
    std::vector<int> across; //!< per triangle side 3 t + k: the side opposite to it, -1 at a border
    std::vector<int> edgeOf; //!< per triangle side: its edge pair, -1 at a border
    std::vector<int> vertex; //!< per soup corner: point of the uncut surface
    int vertexCount = 0;
    std::vector<std::array<int, 2>> ends; //!< per edge pair: the points at its ends
    std::vector<double> length;           //!< per edge pair, solver units
    std::vector<double> cost;             //!< per edge pair, length times painted weight
    std::vector<Rule> rule;               //!< per edge pair
    std::vector<bool> border;             //!< per point: on an open side
    //! Per edge pair: the one that is always cut and closed together with it, itself on the plane of
    //! symmetry, -1 without one; empty when cuts need not be symmetric.
    std::vector<int> mirror;
    std::vector<bool> onPlane; //!< per point: on the plane of symmetry; empty like mirror
    std::vector<int> rank;     //!< per point: place in an order of elimination with little fill

    //! \param symmetry that the cuts shall have, null for none
    [[nodiscard]] static std::shared_ptr<const SeamGraph>
    build(std::shared_ptr<const Soup> soup, const Snapshot &snapshot,
          const preference::MeshSymmetry *symmetry = nullptr);

    bool isMirrored() const { return !mirror.empty(); }
    //! Cuts the mirror images of all cut edges as well.
    void makeSymmetric(CutFlags &cut) const;
    int triangleCount() const { return soup->triangleCount(); }
    std::span<const int> edgesAt(int v) const { return edgesOfPoint[v]; }
    //! The point at the other end of an edge.
    int farEnd(int e, int v) const { return ends[e][0] == v ? ends[e][1] : ends[e][0]; }

    CsrList edgesOfPoint; //!< edges at each point, in rising order
};

} // namespace autocuts::search
