// A UV map whose seams are decided.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/snapshot.h"
#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"

#include <optional>
#include <string>
#include <vector>

namespace autocuts {

//! A UV map whose seams are decided: every edge is either cut or not. Corners that share a UV vertex have
//! bitwise equal coordinates; every triangle is positively oriented.
struct SeamedMap
{
    CutFlags cut;          //!< per edge pair
    std::vector<double> x; //!< coordinates, see Soup

    //! Mean symmetric Dirichlet energy at the best common scale; 4 is isometric. Triangles without area in 3D
    //! are left out.
    double distortion(const Soup &soup) const;
    //! The same with the energy of each triangle above 4 times a factor: what the bound is for where a
    //! snapshot has rigid regions. \param stiffness per triangle; empty: all are 1
    double distortion(const Soup &soup, const std::vector<double> &stiffness) const;
    //! 3D length of the seams in solver units (seam_norm). Diagonals are never seams.
    double seamLength(const Soup &soup) const;
    //! Cost of the seams that a solve minimises: the sum of each edge's weight times its length, or times the
    //! mean edge length when seams are weighted by count. Solver units.
    double seamCost(const Soup &soup, const Snapshot &snapshot) const;
    //! Empty when all invariants hold, else a description of the first broken one.
    std::string validate(const Soup &soup) const;
};

//! 3D length of the edges between two faces whose windings disagree. They are seams of every map, which cut
//! does not have. Scaled as seam_norm, to a mesh area of pi.
double windingSeamLength(const MeshData &mesh);

//! The map that UVs make: edges are cut where the UVs of their sides differ, and where `alwaysCut` says so.
//! \param uv one row per corner, solver units
//! \returns nothing when a corner has no UV, or a triangle is flipped or has no area
[[nodiscard]] std::optional<SeamedMap> seamedMapOf(const Soup &soup, const UvMatrix &uv,
                                                   const CutFlags &alwaysCut);

//! Per chart: true when a pin acts on it. Empty when there are none.
std::vector<bool> heldCharts(const Snapshot &snapshot, const CutMesh &charts);

//! Per-corner UVs of a seamed map, in solver units.
UvMatrix cornerUv(const Soup &soup, const SeamedMap &map);

//! The charts of a cut mesh, per face.
ChartMap chartsOf(const MeshData &mesh, const CutMesh &state);

} // namespace autocuts
