// Lays rigid regions in the plane.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::rigid {

//! Two sides of an edge are together when their ends are nearer than this share of its length.
constexpr double togetherShare = 0.02;

//! The rigid regions in the plane, each in a frame of its own.
struct Unrolled
{
    std::vector<double> x; //!< per soup corner, see Soup; 0 outside of regions
    //! Per edge pair: cut within its region, because the region does not close in the plane there (a ring, or
    //! a seam to the tip of a cone); also true for the borders of regions.
    CutFlags cut;
    std::vector<double> excess; //!< per triangle of a region: its energy above that of an isometry
    //! Per region: false when its map has a flipped triangle or a polygon that does not close.
    std::vector<bool> works;
};

//! Lays every region out triangle by triangle, in waves that cross edges last where seams are cheap. Edges
//! whose sides do not come together are cut; the corners of one UV vertex get the same coordinates. \param
//! weight per edge pair: factor on the cost of a seam; empty: all are 1
[[nodiscard]] Unrolled unroll(const Soup &soup, const RigidRegions &regions,
                              const std::vector<double> &weight = {});

//! The symmetric Dirichlet energy of a triangle above that of an isometry. \param x coordinates, see Soup
[[nodiscard]] double excessOf(const Soup &soup, const std::vector<double> &x, int t);

//! Gives the corners of each UV vertex their mean. \param x coordinates, see Soup
void weld(const CutMesh &state, std::vector<double> &x);

} // namespace autocuts::rigid
