// Dense single-precision kernels of the multifrontal factorisation. Rows of a matrix are contiguous, `stride`
// floats apart; strides are multiples of frontLanes and rows start at multiples of it in aligned memory.
// The functions have many parameters because they are loops over plain arrays.
#pragma once

#include <cstddef>
#include <cstdint>

namespace autocuts::linear {

constexpr int frontLanes = 8;

//! Floats that a row of n takes.
constexpr int paddedRow(int n)
{
    return (n + frontLanes - 1) / frontLanes * frontLanes;
}

//! Replaces a symmetric positive definite n x n matrix by its inverse; all of it is read and written. Returns
//! false when a pivot is not above `smallest`.
[[nodiscard]] bool invertFront(float *a, int n, int stride, float smallest);

//! t = w b: w is p x p, b and t have p rows and are filled up to the stride.
void multiplyFront(const float *w, int wStride, const float *b, float *t, int p, int stride);

//! c = -b^T t, upper triangle (and a little more) of the r x r matrix c; b and t are p x r.
void reduceFront(const float *b, const float *t, int p, int r, int stride, float *c, int cStride);

//! Neighbouring rows of a child's update matrix that are neighbours in the parent's front, too; all in
//! scalars, and even.
struct FrontRun
{
    int begin = 0, end = 0; //!< rows of the child
    int place = 0; //!< of the first of them in the parent's front; no run has rows on both sides of `pivots`
};

//! Adds the upper triangle of a child's update matrix, rows of the runs first to end, to the front of its
//! parent, whose columns from `pivots` on lie in another matrix. \param inPivots,inRows where the row at
//! place 0 begins in the two
void addUpdate(const float *update, int stride, const FrontRun *runs, int first, int end, int count,
               int pivots, float *inPivots, int pivotStride, float *inRows, int rowStride);

//! Entries of a packed row come in groups of this many; so the rows of t have a stride that is a multiple.
constexpr int packedLanes = 2 * frontLanes;

//! Halves the memory of t, p rows of `stride` floats: two entries share a word, each with seven bits behind
//! the point (1 / 256 of itself is the largest error).
void packFront(const float *t, int p, int stride, std::int32_t *packed);

//! Most scalars that a supernode eliminates.
constexpr int largestFront = 32;

//! What solving needs of a supernode that eliminates `pivots` scalars: W, the inverse of their block, and
//! T = W B, packed.
struct PackedFront
{
    int first = 0; //!< of its scalars in the vector of unknowns
    int pivots = 0, pivotStride = 0, stride = 0;
    int rows = 0;                 //!< nodes (two scalars each) that T couples to
    int inside = 0;               //!< as many of them, the first, lie in the vector of unknowns
    const int *numbers = nullptr; //!< where the nodes lie there
    const int *outside = nullptr; //!< where those behind the first `inside` lie in the other vector
    const float *inverse = nullptr;
    const std::int32_t *coupling = nullptr;
};

//! For fronts first to end in this order: the rows' unknowns, in x or in `outside`, minus T^T times the own.
//! \param scratch memory for the longest row
void solveForward(const PackedFront *fronts, int first, int end, float *x, float *outside, float *scratch);

//! For fronts end - 1 down to first: own unknowns = W times themselves - T times the rows' unknowns.
//! \param prefetchAhead how many fronts ahead the factor is fetched; none: 0
void solveBackward(const PackedFront *fronts, int first, int end, int prefetchAhead, float *x,
                   float *scratch);

} // namespace autocuts::linear
