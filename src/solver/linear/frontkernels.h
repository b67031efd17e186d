// Dense single-precision kernels of the multifrontal factorisation. Rows of a matrix are contiguous, `stride`
// floats apart; strides are multiples of frontLanes and rows start at multiples of it in aligned memory.
#pragma once

#include <cstddef>
#include <cstdint>

namespace autocuts {

constexpr int frontLanes = 8;

//! Floats that a row of n takes.
constexpr int paddedRow(int n)
{
    return (n + frontLanes - 1) / frontLanes * frontLanes;
}

//! Replaces a symmetric positive definite n x n matrix by its inverse; all of it is read and written. Returns
//! false when a pivot is not above `smallest`.
bool invertFront(float *a, int n, int stride, float smallest);

//! t = w b: w is p x p, b and t have p rows and are filled up to the stride.
void multiplyFront(const float *w, int wStride, const float *b, float *t, int p, int stride);

//! c -= b^T t, upper triangle (and a little more) of the r x r matrix c; b and t are p x r.
void reduceFront(const float *b, const float *t, int p, int r, int stride, float *c, int cStride);

//! Entries of a packed row come in groups of this many; so the rows of t have a stride that is a multiple.
constexpr int packedLanes = 2 * frontLanes;

//! Halves the memory of t, p rows of `stride` floats: row k is 2^16 scale[k] times whole numbers of 16 bits,
//! two in a word.
void packFront(const float *t, int p, int stride, std::int32_t *packed, float *scale);

//! y -= t^T x with a packed t of p rows; y is as long as a row.
void subtractTransposed(const std::int32_t *t, const float *scale, int p, int stride, const float *x,
                        float *y);

//! y = w x - t z: w is p x p, t packed with p rows; x and z are as long as rows, zero behind their end.
void solvePivots(const float *w, int wStride, const std::int32_t *t, const float *scale, int stride, int p,
                 const float *x, const float *z, float *y);

} // namespace autocuts
