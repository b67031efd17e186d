// Energy and derivatives of the triangles of a patch, several at a time.
#pragma once

#include "solver/search/trianglekernel.h"

#include <vector>

namespace autocuts::search {

//! Rest shapes of triangleLanes triangles. Places after the last triangle of a patch hold that one again.
struct alignas(triangleAlignment) TriangleBlock
{
    TriangleLanes basis[6];  //!< see Soup::Basis
    TriangleLanes weight;    //!< see Soup::weight
    TriangleLanes stiffness; //!< see SeamGraph::stiffness()
};

//! Derivatives of the triangles of a block, times weight and stiffness.
struct alignas(triangleAlignment) BlockDerivatives
{
    TriangleLanes gradient[6], hessian[21]; //!< see dirichletDerivatives()
};

//! Weighted symmetric Dirichlet energies. Infinite where a triangle is flipped.
//! \param point per corner of the patch: the number of its point \param position of the points: u, v
//! \param rigid the stiffness counts
//! \param energy per place of all blocks
void blockEnergies(const std::vector<TriangleBlock> &blocks, const std::vector<int> &point,
                   const std::vector<double> &position, bool rigid, std::vector<double> &energy);

//! Derivatives of the symmetric Dirichlet energy in one block; the other parameters as above.
void blockDerivatives(const std::vector<TriangleBlock> &blocks, std::size_t which,
                      const std::vector<int> &point, const std::vector<double> &position,
                      BlockDerivatives &derivatives);

} // namespace autocuts::search
