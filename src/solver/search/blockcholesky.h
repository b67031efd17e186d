// Sparse Cholesky factorisation of small symmetric positive definite matrices of 2 x 2 blocks.
#pragma once

#include "solver/base/jobcontext.h"

#include <array>
#include <utility>
#include <vector>

namespace autocuts::search {

//! Up-looking Cholesky factorisation for the many small systems of the seam search: tens to some thousands of
//! unknown points, two coordinates each. At these sizes a general library spends most of its time on
//! bookkeeping. Buffers are reused from one system to the next.
class BlockCholesky
{
public:
    //! A 2 x 2 block, row by row.
    using Block = std::array<double, 4>;

    //! Sets the pattern of a new matrix with `count` block rows, numbered in the order of elimination.
    //! \param lower blocks below the diagonal, as pairs (row, column) with row > column; duplicates are
    //! allowed
    void analyze(int count, const std::vector<std::pair<int, int>> &lower);

    //! Number of block rows.
    int count() const { return mCount; }
    //! Sets all values to zero.
    void clear();
    //! Index of block (row, column) for offDiagonal(). \pre the block is in the pattern, row > column
    int place(int row, int column) const;
    Block &offDiagonal(int place) { return mValue[place]; }
    //! Diagonal block; only its lower triangle is read.
    Block &diagonal(int row) { return mDiagonal[row]; }

    //! \returns false when the matrix is not positive definite, or when stopped
    [[nodiscard]] bool factorize(const JobContext &job = {});
    //! Replaces the right-hand side by the solution. \pre factorize() returned true
    //! \param b two numbers per block row
    void solve(double *b) const;

private:
    //! SIMD vectors of two and of four numbers.
    using Pair = double __attribute__((vector_size(2 * sizeof(double))));
    using Quad = double __attribute__((vector_size(4 * sizeof(double))));
    struct alignas(4 * sizeof(double)) Rows
    {
        Quad both; //!< a 2 x 2 block, row by row
    };
    struct alignas(4 * sizeof(double)) Columns
    {
        Pair first, second; //!< columns of a 2 x 2 block
    };

    void findRows();

    int mCount = 0;
    // The matrix: blocks below the diagonal in compressed rows, and the diagonal blocks.
    std::vector<int> mRowStart, mColumn;
    std::vector<Block> mValue, mDiagonal;
    // The factor: the elimination tree (mParent), the columns of each row in order of elimination (mPattern),
    // the rows of each column (mRowIndex) and the blocks column by column (mFactor).
    std::vector<int> mParent, mMark, mPatternStart, mPattern, mColumnStart, mRowIndex, mFilled;
    std::vector<Columns> mFactor;
    std::vector<Rows> mWork;
    std::vector<Block> mPivot; //!< inverses of the factor's lower triangular diagonal blocks
};

} // namespace autocuts::search
