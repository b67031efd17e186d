// The edges of the mesh as a graph for the seam search. Immutable.
#pragma once

#include "model/plain/csrlist.h"
#include "model/plain/snapshot.h"
#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/search/anchors.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace autocuts::search {

//! The sides after and before a side in its triangle; so for the corners, each of which has the number of the
//! side that begins at it.
inline int nextSide(int side)
{
    return side % 3 == 2 ? side - 2 : side + 1;
}

inline int sideBefore(int side)
{
    return side % 3 == 0 ? side + 2 : side - 1;
}

//! Vertices and edges of the uncut surface, with edge costs and the user's steering. Immutable after
//! build(). The vertices are those of the uncut surface: corners connected over edges that are not open.
struct SeamGraph
{
    enum class Rule : std::uint8_t { Free, AlwaysCut, NeverCut };

    std::shared_ptr<const Soup> soup;
    std::vector<int> across; //!< per triangle side 3 t + k: the side of the other triangle, -1 at a border
    std::vector<int> edgeOf; //!< per triangle side: its edge pair, -1 at a border
    std::vector<int> vertex; //!< per soup corner: its vertex
    int vertexCount = 0;
    std::vector<std::array<int, 2>> ends; //!< per edge pair: the vertices at its ends
    std::vector<double> length;           //!< per edge pair, solver units
    //! Per edge pair: length (or the mean edge length when seams are weighted by count) times painted weight,
    //! solver units.
    std::vector<double> cost;
    std::vector<Rule> rule;   //!< per edge pair
    std::vector<bool> border; //!< per vertex: on an open side
    //! Per edge pair: its mirror image, always cut and stitched together with it; the edge itself when it is
    //! its own image; -1: no image. Empty when cuts need not be symmetric.
    std::vector<int> mirror;
    std::vector<bool> onPlane; //!< per vertex: on the plane of symmetry; empty like mirror
    std::vector<int> rank;     //!< per vertex: position in an elimination order with little fill
    DistortionEnergy energy = DistortionEnergy::SymmetricDirichlet; //!< what maps minimise beside the cost
    std::shared_ptr<const std::vector<bool>> aligned;               //!< see Snapshot::aligned
    //! Regions that keep their shape; null: none. Their stiffness is part of the energy, what it sets apart
    //! is always cut.
    std::shared_ptr<const RigidRegions> rigid;
    Anchors anchors; //!< pins; rectangles only while charts are fitted into them
    std::shared_ptr<const std::vector<Obstacle>> obstacles; //!< for charts with anchors; null: none

    //! \param symmetry symmetry that the cuts must have; null: none
    [[nodiscard]] static std::shared_ptr<const SeamGraph>
    build(std::shared_ptr<const Soup> soup, const Snapshot &snapshot,
          const preference::MeshSymmetry *symmetry = nullptr);
    //! The same graph with the steering and the settings of another snapshot of the same mesh.
    [[nodiscard]] std::shared_ptr<const SeamGraph>
    steeredBy(const Snapshot &snapshot, const preference::MeshSymmetry *symmetry = nullptr) const;

    bool isMirrored() const { return !mirror.empty(); }
    //! True when a map has no other energy than the distortion that the bound is for.
    bool hasPlainEnergy() const { return anchors.empty() && energy == DistortionEnergy::SymmetricDirichlet; }
    //! Cuts the mirror images of all cut edges too, except those that must not be cut.
    void makeSymmetric(CutFlags &cut) const;
    int triangleCount() const { return soup->triangleCount(); }
    //! Factor on the energy of a triangle above that of an isometry.
    double stiffness(int t) const { return rigid ? rigid->stiffness[t] : 1; }
    std::span<const int> edgesAt(int v) const { return edgesOfPoint[v]; }
    //! The vertex at the other end of an edge.
    int farEnd(int e, int v) const { return ends[e][0] == v ? ends[e][1] : ends[e][0]; }

    CsrList edgesOfPoint; //!< per vertex: its edge pairs, in ascending order

private:
    void setSteering(const Snapshot &snapshot, const preference::MeshSymmetry *symmetry);
};

} // namespace autocuts::search
