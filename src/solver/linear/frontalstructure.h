// Structure of a multifrontal Cholesky factorisation: elimination tree, supernodes, and where fronts are
// added to their parents.
#pragma once

#include "solver/linear/frontkernels.h"
#include "solver/linear/linearsolver.h"

#include <vector>

namespace autocuts::linear {

//! Nodes stand for 2 x 2 blocks of the matrix. They are renumbered so that a supernode eliminates consecutive
//! nodes and children come before their parents. The front of a supernode holds its own nodes first, then
//! `rows`.
struct FrontalStructure
{
    struct Supernode
    {
        int first = 0, count = 0; //!< nodes eliminated, in the new numbers
        int parent = -1;
        int rowBegin = 0, rowCount = 0; //!< range in `rows`
    };
    //! A 2 x 2 block of the matrix and its position in the front, in nodes, row <= column.
    struct Entry
    {
        int first, second; //!< indices into the matrix's values: top of the block in its two columns
        int row, column;
    };

    int nodeCount = 0;
    std::vector<int> newNumber;            //!< per node
    std::vector<Supernode> supernodes;     //!< children first
    std::vector<int> rows;                 //!< nodes, ascending in the new numbers
    std::vector<int> runBegin;             //!< per supernode; one more entry for the end
    std::vector<FrontRun> runs;            //!< positions of its rows in the parent's front
    std::vector<int> childBegin, children; //!< per supernode, ascending
    std::vector<int> entryBegin;           //!< per supernode
    std::vector<Entry> entries;

    //! \param lower lower triangle of a symmetric matrix of full 2 x 2 blocks, ordered so that the fill is
    //! low
    static FrontalStructure build(const LinearSolver::Matrix &lower);
};

} // namespace autocuts::linear
