// A chart of a seamed map as a problem of its own: its points, triangles and borders.
#pragma once

#include "model/plain/types.h"
#include "solver/base/cutmesh.h"
#include "solver/base/jobcontext.h"
#include "solver/base/soup.h"

#include <array>
#include <vector>

namespace autocuts::straight {

using Positions = std::vector<Vec2>; //!< per point of an island, solver units

//! One chart. A point is a UV vertex of it.
struct Island
{
    //! A loop of its border, with the island on the left. Side i runs from point[i] to the next one.
    struct Loop
    {
        std::vector<int> point;
        std::vector<double> length; //!< per side, on the model, solver units
        //! Per point: how much the border turns there on the model, within the surface; radians, positive to
        //! the left.
        std::vector<double> turn;
    };

    std::vector<int> triangles;             //!< of the mesh
    std::vector<std::array<int, 3>> points; //!< per triangle
    std::vector<Soup::Basis> basis;         //!< per triangle
    std::vector<double> weight;             //!< per triangle: share of the area of the mesh
    std::vector<double> stiffness; //!< per triangle: factor on its energy above that of an isometry; empty: 1
    std::vector<Loop> loops;
    Positions position;

    int pointCount() const { return static_cast<int>(position.size()); }
    //! Its area on the model, solver units.
    double area() const;
    //! Factor on the derivatives of a triangle's energy.
    double stiffWeight(std::size_t t) const { return weight[t] * (stiffness.empty() ? 1 : stiffness[t]); }
    //! Sum of the symmetric Dirichlet energy of its triangles, with their stiffness, times their weights;
    //! infinite where one is flipped.
    double energy(const Positions &at) const;
    //! True when it overlaps itself, or when stopped.
    bool coversItself(const Positions &at, const JobContext &job = {}) const;
};

//! The islands of a map. \param x coordinates, see Soup
std::vector<Island> islandsOf(const Soup &soup, const CutMesh &charts, const std::vector<double> &x);

//! Writes the positions of an island into the coordinates.
void store(const Island &island, const Positions &at, std::vector<double> &x);

} // namespace autocuts::straight
