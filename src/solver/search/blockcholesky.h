// Sparse Cholesky factorisation of small symmetric matrices of 2 x 2 blocks.
#pragma once

#include <array>
#include <utility>
#include <vector>

namespace autocuts::search {

//! Up-looking Cholesky for the many small systems of the seam search (tens to some thousands of unknown
//! points), where a general library spends most of its time on bookkeeping. Keeps its memory between systems.
class BlockCholesky
{
public:
    //! A 2 x 2 block, row by row.
    using Block = std::array<double, 4>;

    //! Starts a new pattern of `count` block rows, in the order of elimination.
    //! \param lower pairs (row, column) with row > column; repetitions are fine
    void analyze(int count, std::vector<std::pair<int, int>> &lower);

    int count() const { return mCount; }
    //! Sets all values to zero.
    void clear();
    //! Place of block (row, column) among the values. \pre it is in the pattern, row > column
    int place(int row, int column) const;
    Block &offDiagonal(int place) { return mValue[place]; }
    //! Diagonal block; only its lower triangle is used.
    Block &diagonal(int row) { return mDiagonal[row]; }

    //! False when a pivot is not positive.
    [[nodiscard]] bool factorize();
    //! Solves in place: two numbers per block row. \pre factorize() returned true
    void solve(double *b) const;

private:
    //! Two numbers that are added and multiplied together.
    using Pair = double __attribute__((vector_size(2 * sizeof(double))));
    struct Rows
    {
        Pair first, second; //!< of a 2 x 2 block
    };
    struct Columns
    {
        Pair first, second;
    };

    void findRows();

    int mCount = 0;
    // The matrix, row by row.
    std::vector<int> mRowStart, mColumn;
    std::vector<Block> mValue, mDiagonal;
    // The factor: the columns of each row in order of elimination, the rows of each column, the blocks.
    std::vector<int> mParent, mMark, mPatternStart, mPattern, mColumnStart, mRowIndex, mFilled;
    std::vector<Columns> mFactor;
    std::vector<Rows> mWork;
    std::vector<Block> mPivot; //!< inverses of the lower triangular diagonal blocks
};

} // namespace autocuts::search
