// Dense single-precision kernels of the multifrontal factorisation. Rows of a matrix are contiguous, `stride`
// floats apart; strides are multiples of frontLanes, and rows start at multiples of frontLanes in aligned
// memory. The functions have many parameters because they are loops over plain arrays.
#pragma once

#include <cstddef>
#include <cstdint>

namespace autocuts::linear {

//! Floats in a vector: as many as an AVX register holds.
constexpr int frontLanes = 8;

//! Number of floats that a padded row of n entries takes.
constexpr int paddedRow(int n)
{
    return (n + frontLanes - 1) / frontLanes * frontLanes;
}

//! Replaces a symmetric positive definite n x n matrix by its inverse; both triangles are read and written.
//! \return false when a pivot is not above `smallest`
[[nodiscard]] bool invertFront(float *a, int n, int stride, float smallest);

//! t = w b, where w is p x p, and b and t have p rows filled up to the stride.
void multiplyFront(const float *w, int wStride, const float *b, float *t, int p, int stride);

//! c = -b^T t, upper triangle (and a little more) of the r x r matrix c; b and t are p x r.
void reduceFront(const float *b, const float *t, int p, int r, int stride, float *c, int cStride);

//! Adjacent rows of a child's update matrix that are adjacent in the parent's front, too. All numbers count
//! scalars and are even.
struct FrontRun
{
    int begin = 0, end = 0; //!< rows of the child
    int place = 0;          //!< position of the first one in the parent's front; no run crosses `pivots`
};

//! Adds the upper triangle of a child's update matrix (the rows of runs first to end) to the front of its
//! parent, whose columns from `pivots` on are stored in another matrix.
//! \param inPivots,inRows start of the row at position 0 in the two matrices
void addUpdate(const float *update, int stride, const FrontRun *runs, int first, int end, int count,
               int pivots, float *inPivots, int pivotStride, float *inRows, int rowStride);

//! Entries of a packed row come in groups of this size, so the stride of t is a multiple of it.
constexpr int packedLanes = 2 * frontLanes;

//! Halves the memory of t, p rows of `stride` floats: two entries share a word, each with a 7-bit mantissa
//! (relative error at most 1 / 256).
void packFront(const float *t, int p, int stride, std::int32_t *packed);

//! Most scalars that a supernode eliminates: 16 nodes, chosen by hand.
constexpr int largestFront = 32;

//! What a solve needs of a supernode that eliminates `pivots` scalars: W, the inverse of their block, and T =
//! W B, packed.
struct PackedFront
{
    int first = 0; //!< position of its scalars in the vector of unknowns
    int pivots = 0, pivotStride = 0, stride = 0;
    int rows = 0;                 //!< nodes (two scalars each) that T couples to
    int inside = 0;               //!< how many of these, the first ones, are in the vector of unknowns
    const int *numbers = nullptr; //!< node numbers of the rows: positions in the vector of unknowns
    const int *outside = nullptr; //!< positions in the other vector of the nodes after the first `inside`
    const float *inverse = nullptr;
    const std::int32_t *coupling = nullptr;
};

//! For fronts first to end, in this order: the unknowns of the rows, in x or in `outside`, minus T^T times
//! the front's own unknowns.
//! \param scratch memory for the longest row
void solveForward(const PackedFront *fronts, int first, int end, float *x, float *outside, float *scratch);

//! For fronts end - 1 down to first: own unknowns = W times themselves minus T times the unknowns of the
//! rows.
//! \param prefetchAhead how many fronts ahead the factor is prefetched; 0: not at all
void solveBackward(const PackedFront *fronts, int first, int end, int prefetchAhead, float *x,
                   float *scratch);

} // namespace autocuts::linear
