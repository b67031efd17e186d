// Grouping of soup corners into hubs, and the sparse matrix of the hubs.
#pragma once

#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"
#include "solver/linear/linearsolver.h"
#include "solver/newton/hubkernels.h"

#include <vector>

namespace autocuts::newton {

//! Groups of two or more corners connected by closed pairs. Hubs are numbered in an order of elimination.
struct HubGroups
{
    int count = 0;
    std::vector<int> hub;     //!< per soup corner; -1 for a corner without a hub
    std::vector<int> begin;   //!< per hub, and the end: start of its corners in `corners`
    std::vector<int> corners; //!< ordered by hub; corners without a hub last

    //! \param rank per mesh vertex, its position in the order of elimination
    static HubGroups build(const Soup &soup, const energy::HessianBlocks &blocks,
                           const std::vector<int> &rank);
    //! \returns false when too many closed pairs are not within one hub, or too many pairs within hubs are
    //! open (a few do no harm: their springs are weak)
    bool stillFit(const Soup &soup, const energy::HessianBlocks &blocks) const;
};

//! The hub matrix A = B - sum over triangles of D S^-1 D (see hubdirection.cpp). The pattern consists of full
//! 2 x 2 blocks.
class HubMatrix
{
public:
    void setPattern(const Soup &soup, const HubGroups &groups);
    //! \pre setPattern() was called with `groups`
    void fill(const Soup &soup, const energy::HessianBlocks &blocks, const HubGroups &groups,
              const std::vector<BlockInverse> &inverses);
    void addToDiagonal(double shift);
    const linear::LinearSolver::Matrix &matrix() const { return mMatrix; }

private:
    double *secondColumn(int place, int column);
    int addTriangle(const int *hub, const int *places, const BlockInverse &inverse, int lane);

    linear::LinearSolver::Matrix mMatrix;
    std::vector<int> mPlaces; //!< positions of the blocks below the diagonal that triangles and pairs add to
};

} // namespace autocuts::newton
