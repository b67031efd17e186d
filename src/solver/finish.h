// From the live soup to a real UV map: joins what is nearly joined, cuts the rest (paper, section 4,
// "Finalizing the UV map"), without a flipped or degenerate triangle.
#pragma once

#include "model/snapshot.h"
#include "solver/cutmesh.h"
#include "solver/soup.h"

#include <atomic>
#include <string>
#include <vector>

namespace autocuts {

//! A UV map with definite seams. Corners that share a UV vertex have bitwise equal coordinates; every triangle
//! is positively oriented.
struct SeamedMap
{
    CutFlags cut;             //!< per edge pair
    std::vector<double> x;    //!< coordinates, see Soup

    //! Mean symmetric Dirichlet energy at the best common scale; 4 is isometric. Triangles without area in 3D do
    //! not count.
    double distortion(const Soup &soup) const;
    //! 3D length of the seams in solver units: seam_norm. Diagonals are never seams.
    double seamLength(const Soup &soup) const;
    //! What a solve makes small: their length or count, each edge times its weight.
    double seamCost(const Soup &soup, const Snapshot &snapshot) const;
    //! Empty when all invariants hold, else the first broken one.
    std::string validate(const Soup &soup) const;
};

//! Merges the corner pairs whose separation is below 0.5 (always on diagonals and joined pairs, never on cut
//! ones) and puts each merged corner at the average. Where that would flip a triangle the pairs are pulled
//! together step by step with the distortion minimised; what still flips stays cut.
//! \pre every triangle is positively oriented at x
SeamedMap finishMap(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                    const std::vector<double> &x, const std::atomic<bool> *cancel = nullptr);

//! Closes the given map to other cut flags, as finishMap() does. Edges that cannot be closed stay cut.
SeamedMap closeTo(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, CutFlags cut,
                  const std::vector<double> &x, const std::atomic<bool> *cancel = nullptr);

//! Minimises the distortion (and pins and rectangles) with the seams fixed, at most `steps` Newton steps or until the
//! energy stalls. Returns the number of steps.
int relaxMap(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map, int steps,
             const std::atomic<bool> *cancel = nullptr);

} // namespace autocuts
