// Edges along which two rigid regions can stay together without stretch.
#pragma once

#include "solver/base/rigidfit.h"
#include "solver/rigid/planemotion.h"
#include "solver/rigid/unrolling.h"

#include <vector>

namespace autocuts::rigid {

//! The edges between two regions that one motion closes: those on one line of both, mostly. Where a region is
//! curved, edges that leave a small gap are closed, too.
struct Hinge
{
    int first = 0, second = 0; //!< regions, first < second
    std::vector<int> edges;    //!< edge pairs
    double length = 0;         //!< solver units
    PlaneMotion motion;        //!< takes the second region to where it continues the first one
    double gap = 0;            //!< between the ends of an edge's sides, at most; solver units
};

//! All hinges between different regions, of regions that work, without edges that must be seams.
//! \param alwaysCut per edge pair
[[nodiscard]] std::vector<Hinge> findHinges(const Soup &soup, const RigidRegions &regions,
                                            const Unrolled &unrolled, const CutFlags &alwaysCut);

//! The motion that closes a hinge best, with all of its edges. \param x where its regions lie, see Soup
[[nodiscard]] RigidMotion motionOf(const std::vector<double> &x, const MeshData &mesh,
                                   const RigidRegions &regions, const Hinge &hinge);

//! Length of the border of each region, solver units.
[[nodiscard]] std::vector<double> borderLengths(const Soup &soup, const RigidRegions &regions,
                                                const Unrolled &unrolled);

//! A region may hang on by a hinge that is longer than this share of its border.
inline constexpr double leastHinge = 1.0 / 6;

//! Per edge pair: true on hinges that are too short for both of their regions: there is always a seam.
//! Regions too small to be islands stay where they are.
[[nodiscard]] std::vector<bool> edgesApart(const Soup &soup, const RigidRegions &regions,
                                           const Unrolled &unrolled, const std::vector<Hinge> &hinges);

} // namespace autocuts::rigid
