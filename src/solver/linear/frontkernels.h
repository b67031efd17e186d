// Dense single-precision kernels of the multifrontal factorisation. Rows of a matrix are contiguous, `stride`
// floats apart; strides are multiples of frontLanes and rows start at multiples of it in aligned memory.
#pragma once

#include <cstddef>

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

//! t = w b: w is p x p, b and t are p x r.
void multiplyFront(const float *w, int wStride, const float *b, float *t, int p, int r, int stride);

//! c -= b^T t, upper triangle (and a little more) of the r x r matrix c; b and t are p x r.
void reduceFront(const float *b, const float *t, int p, int r, int stride, float *c, int cStride);

//! y -= t^T x with t p x r, the rows padded and y as long as a padded row.
void subtractTransposed(const float *t, int p, int r, int stride, const float *x, float *y);

//! y = w x - t z: w is p x p, t is p x r; x and z are as long as padded rows, zero behind their end.
void solvePivots(const float *w, int wStride, const float *t, int stride, int p, int r, const float *x,
                 const float *z, float *y);

} // namespace autocuts
