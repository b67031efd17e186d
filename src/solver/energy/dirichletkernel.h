// Symmetric Dirichlet energy of eight triangles at a time.
#pragma once

#include "solver/base/lanes.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::energy {

using DoubleLanes = double __attribute__((vector_size(laneCount * sizeof(double))));

//! Rest shapes of eight triangles. Behind the last triangle of a soup: a right triangle without weight.
struct alignas(2 * laneAlignment) DirichletBlock
{
    DoubleLanes
        basis[4]; //!< gradients of the corners 1 and 2, see Soup::Basis; that of corner 0 is minus their sum
    DoubleLanes weight;
};

std::vector<DirichletBlock> dirichletBlocks(const Soup &soup);

//! Sum of weight * energy over `triangles` triangles from the first of `blocks` on, whose coordinates are x;
//! infinite when one is flipped.
double dirichletSum(const DirichletBlock *blocks, const double *x, int triangles);

//! The same sum; adds factor times the gradient to `gradient` and writes factor times the positive
//! semidefinite Hessian to `hessian`, one matrix per block.
double dirichletDerivatives(const DirichletBlock *blocks, const double *x, int triangles, double factor,
                            double *gradient, EdgeMatrix *hessian);

//! Smallest step, up to `limit`, at which one of the triangles at x loses its area along `direction`.
double flipFreeStep(const double *x, const double *direction, int triangles, double limit);

} // namespace autocuts::energy
