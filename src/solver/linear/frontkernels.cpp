#include "solver/linear/frontkernels.h"

#include "solver/linear/simd.h"

namespace autocuts {

namespace {

using Lanes = float __attribute__((vector_size(frontLanes * sizeof(float)), may_alias));

inline Lanes *lanes(float *p)
{
    return reinterpret_cast<Lanes *>(p);
}

inline const Lanes *lanes(const float *p)
{
    return reinterpret_cast<const Lanes *>(p);
}

inline float sumOf(const Lanes &v)
{
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

} // namespace

AUTOCUTS_CLONES
bool invertFront(float *a, int n, int stride, float smallest)
{
    // Gauss-Jordan without a choice of pivots, which positive definite matrices do not need.
    const int width = paddedRow(n) / frontLanes;
    for (int k = 0; k < n; ++k) {
        float *row = a + static_cast<std::ptrdiff_t>(k) * stride;
        const float pivot = row[k];
        if (!(pivot > smallest))
            return false;
        const float inverse = 1 / pivot;
        row[k] = 1;
        Lanes *scaled = lanes(row);
        for (int j = 0; j < width; ++j)
            scaled[j] *= inverse;
        for (int i = 0; i < n; ++i) {
            if (i == k)
                continue;
            float *other = a + static_cast<std::ptrdiff_t>(i) * stride;
            const float factor = other[k];
            other[k] = 0;
            Lanes *target = lanes(other);
            for (int j = 0; j < width; ++j)
                target[j] -= factor * scaled[j];
        }
    }
    return true;
}

AUTOCUTS_CLONES
void multiplyFront(const float *w, int wStride, const float *b, float *t, int p, int r, int stride)
{
    const int width = paddedRow(r) / frontLanes;
    int i = 0;
    for (; i + 4 <= p; i += 4) {
        const float *w0 = w + static_cast<std::ptrdiff_t>(i) * wStride;
        const float *w1 = w0 + wStride, *w2 = w1 + wStride, *w3 = w2 + wStride;
        for (int j = 0; j < width; ++j) {
            Lanes s0{}, s1{}, s2{}, s3{};
            for (int k = 0; k < p; ++k) {
                const Lanes column = lanes(b + static_cast<std::ptrdiff_t>(k) * stride)[j];
                s0 += w0[k] * column;
                s1 += w1[k] * column;
                s2 += w2[k] * column;
                s3 += w3[k] * column;
            }
            float *out = t + static_cast<std::ptrdiff_t>(i) * stride;
            lanes(out)[j] = s0;
            lanes(out + stride)[j] = s1;
            lanes(out + 2 * static_cast<std::ptrdiff_t>(stride))[j] = s2;
            lanes(out + 3 * static_cast<std::ptrdiff_t>(stride))[j] = s3;
        }
    }
    for (; i < p; ++i) {
        const float *row = w + static_cast<std::ptrdiff_t>(i) * wStride;
        for (int j = 0; j < width; ++j) {
            Lanes sum{};
            for (int k = 0; k < p; ++k)
                sum += row[k] * lanes(b + static_cast<std::ptrdiff_t>(k) * stride)[j];
            lanes(t + static_cast<std::ptrdiff_t>(i) * stride)[j] = sum;
        }
    }
}

AUTOCUTS_CLONES
void reduceFront(const float *b, const float *t, int p, int r, int stride, float *c, int cStride)
{
    const int width = paddedRow(r) / frontLanes;
    int i = 0;
    for (; i + 4 <= r; i += 4) {
        float *out = c + static_cast<std::ptrdiff_t>(i) * cStride;
        // From the diagonal on; in pairs of vectors as far as that goes.
        int j = i / frontLanes;
        for (; j + 2 <= width; j += 2) {
            Lanes s00{}, s01{}, s10{}, s11{}, s20{}, s21{}, s30{}, s31{};
            for (int k = 0; k < p; ++k) {
                const float *factor = b + static_cast<std::ptrdiff_t>(k) * stride + i;
                const Lanes *row = lanes(t + static_cast<std::ptrdiff_t>(k) * stride) + j;
                const Lanes t0 = row[0], t1 = row[1];
                s00 += factor[0] * t0;
                s01 += factor[0] * t1;
                s10 += factor[1] * t0;
                s11 += factor[1] * t1;
                s20 += factor[2] * t0;
                s21 += factor[2] * t1;
                s30 += factor[3] * t0;
                s31 += factor[3] * t1;
            }
            const std::ptrdiff_t step = cStride;
            lanes(out)[j] -= s00;
            lanes(out)[j + 1] -= s01;
            lanes(out + step)[j] -= s10;
            lanes(out + step)[j + 1] -= s11;
            lanes(out + 2 * step)[j] -= s20;
            lanes(out + 2 * step)[j + 1] -= s21;
            lanes(out + 3 * step)[j] -= s30;
            lanes(out + 3 * step)[j + 1] -= s31;
        }
        for (; j < width; ++j) {
            Lanes s0{}, s1{}, s2{}, s3{};
            for (int k = 0; k < p; ++k) {
                const float *factor = b + static_cast<std::ptrdiff_t>(k) * stride + i;
                const Lanes row = lanes(t + static_cast<std::ptrdiff_t>(k) * stride)[j];
                s0 += factor[0] * row;
                s1 += factor[1] * row;
                s2 += factor[2] * row;
                s3 += factor[3] * row;
            }
            const std::ptrdiff_t step = cStride;
            lanes(out)[j] -= s0;
            lanes(out + step)[j] -= s1;
            lanes(out + 2 * step)[j] -= s2;
            lanes(out + 3 * step)[j] -= s3;
        }
    }
    for (; i < r; ++i) {
        for (int j = i / frontLanes; j < width; ++j) {
            Lanes sum{};
            for (int k = 0; k < p; ++k)
                sum += b[static_cast<std::ptrdiff_t>(k) * stride + i] *
                       lanes(t + static_cast<std::ptrdiff_t>(k) * stride)[j];
            lanes(c + static_cast<std::ptrdiff_t>(i) * cStride)[j] -= sum;
        }
    }
}

AUTOCUTS_CLONES
void subtractTransposed(const float *t, int p, int r, int stride, const float *x, float *y)
{
    const int width = paddedRow(r) / frontLanes;
    int j = 0;
    for (; j + 4 <= width; j += 4) {
        Lanes s0 = lanes(y)[j], s1 = lanes(y)[j + 1], s2 = lanes(y)[j + 2], s3 = lanes(y)[j + 3];
        for (int k = 0; k < p; ++k) {
            const Lanes *row = lanes(t + static_cast<std::ptrdiff_t>(k) * stride) + j;
            s0 -= x[k] * row[0];
            s1 -= x[k] * row[1];
            s2 -= x[k] * row[2];
            s3 -= x[k] * row[3];
        }
        lanes(y)[j] = s0;
        lanes(y)[j + 1] = s1;
        lanes(y)[j + 2] = s2;
        lanes(y)[j + 3] = s3;
    }
    for (; j < width; ++j) {
        Lanes sum = lanes(y)[j];
        for (int k = 0; k < p; ++k)
            sum -= x[k] * lanes(t + static_cast<std::ptrdiff_t>(k) * stride)[j];
        lanes(y)[j] = sum;
    }
}

AUTOCUTS_CLONES
void solvePivots(const float *w, int wStride, const float *t, int stride, int p, int r, const float *x,
                 const float *z, float *y)
{
    const int pivotWidth = paddedRow(p) / frontLanes;
    const int width = paddedRow(r) / frontLanes;
    for (int k = 0; k < p; ++k) {
        const Lanes *inverse = lanes(w + static_cast<std::ptrdiff_t>(k) * wStride);
        const Lanes *row = lanes(t + static_cast<std::ptrdiff_t>(k) * stride);
        Lanes even{}, odd{};
        for (int j = 0; j < pivotWidth; ++j)
            even += inverse[j] * lanes(x)[j];
        int j = 0;
        for (; j + 2 <= width; j += 2) {
            even -= row[j] * lanes(z)[j];
            odd -= row[j + 1] * lanes(z)[j + 1];
        }
        if (j < width)
            even -= row[j] * lanes(z)[j];
        const Lanes total = even + odd;
        y[k] = sumOf(total);
    }
}

} // namespace autocuts
