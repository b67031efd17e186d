// Interface of the terms of the energy, and the form of their Hessians.
#pragma once

#include "solver/base/lanes.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace autocuts::energy {

//! A positive semidefinite Hessian, stored as all terms need it: a 6 x 6 block per triangle, a spring per
//! corner pair, and a diagonal.
struct HessianBlocks
{
    //! How the blocks of the triangles are stored.
    enum class Precision { Double, Single };

    //! Double: lower triangle of the 6 x 6 block of each triangle, row by row: (0,0) (1,0) (1,1) (2,0) ...
    std::vector<std::array<double, 21>> triangle;
    //! Single: the same blocks over the edge vectors of eight triangles at a time (moving a whole triangle
    //! costs nothing), zero after the last triangle. Only the distortion term writes them.
    std::vector<EdgeMatrix> lanes;
    //! Spring constant w of each corner pair, for the energy w / 2 * |x_a - x_b|^2. Only the separation term
    //! writes them; new entries are zero.
    std::vector<double> pair;
    std::vector<std::uint8_t> pairClosed; //!< 1 where the pair nearly coincides (a hint for preconditioners)
    int triangleCount = 0;
    std::vector<double> ground; //!< added to the diagonal, per coordinate; empty: all zero

    void resize(int triangles, int pairs, Precision precision = Precision::Double)
    {
        if (precision == Precision::Double)
            triangle.assign(triangles, {});
        else
            lanes.resize((triangles + laneCount - 1) / laneCount);
        pair.resize(pairs);
        pairClosed.resize(pairs);
        ground.clear();
        triangleCount = triangles;
    }

    //! `ground`, resized to hold every coordinate.
    std::vector<double> &addedGround()
    {
        ground.resize(6 * static_cast<std::size_t>(triangleCount), 0.0);
        return ground;
    }
};

//! One term of the energy, a function of the coordinates x of a Soup (see soup.h).
class EnergyTerm
{
public:
    virtual ~EnergyTerm() = default;

    //! The term at x; infinite where a triangle is flipped or has no area, if the term forbids that.
    virtual double value(std::span<const double> x) const = 0;
    //! Adds the gradient to `gradient` and a positive semidefinite model of the Hessian to `blocks`.
    //! \return value(x)
    //! \pre value(x) is finite; `blocks` has been resized
    virtual double addDerivatives(std::span<const double> x, std::span<double> gradient,
                                  HessianBlocks &blocks) const = 0;
};

} // namespace autocuts::energy
