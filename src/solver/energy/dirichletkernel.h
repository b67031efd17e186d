// Symmetric Dirichlet energy of eight triangles at a time.
#pragma once

#include "solver/base/lanes.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::energy {

using DoubleLanes = double __attribute__((vector_size(laneCount * sizeof(double))));

//! Rest shapes of eight triangles. Places after the last triangle of a soup hold a right triangle of weight
//! 0.
struct alignas(2 * laneAlignment) DirichletBlock
{
    DoubleLanes
        basis[4]; //!< gradients of the corners 1 and 2, see Soup::Basis; that of corner 0 is minus their sum
    DoubleLanes weight;
};

std::vector<DirichletBlock> dirichletBlocks(const Soup &soup);

//! Sum of weight * energy over `triangles` triangles, the first of which is the first of `blocks`; x holds
//! their coordinates. Infinite when one is flipped.
double dirichletSum(const DirichletBlock *blocks, const double *x, int triangles);

//! The same sum. Also adds factor times the gradient to `gradient` and writes factor times the positive
//! semidefinite Hessian to `hessian`, one matrix per block.
double dirichletDerivatives(const DirichletBlock *blocks, const double *x, int triangles, double factor,
                            double *gradient, EdgeMatrix *hessian);

//! Smallest step, at most `limit`, at which one of the triangles at x loses its area when it moves along
//! `direction`.
double flipFreeStep(const double *x, const double *direction, int triangles, double limit);

} // namespace autocuts::energy
