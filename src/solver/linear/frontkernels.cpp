#include "solver/linear/frontkernels.h"

#include "solver/linear/simd.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! What the largest entry of a packed row becomes.
constexpr float packedLimit = 32767;

using Lanes = float __attribute__((vector_size(frontLanes * sizeof(float)), may_alias));

inline Lanes *lanes(float *p)
{
    return reinterpret_cast<Lanes *>(p);
}

inline const Lanes *lanes(const float *p)
{
    return reinterpret_cast<const Lanes *>(p);
}

using WholeLanes = std::int32_t __attribute__((vector_size(frontLanes * sizeof(std::int32_t)), may_alias));

//! Sixteen entries of a packed row, 2^16 times too large: taking halves of words is quicker than widening.
inline void unpack(const std::int32_t *p, Lanes &first, Lanes &second)
{
    const WholeLanes both = *reinterpret_cast<const WholeLanes *>(p);
    first = __builtin_convertvector(both << 16, Lanes);
    second = __builtin_convertvector(both & -65536, Lanes);
}

inline float sumOf(const Lanes &v)
{
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

//! Sums of four vectors at once, each added up as sumOf() does.
inline void sumsOf(const Lanes &a, const Lanes &b, const Lanes &c, const Lanes &d, float *sums)
{
    using Order = int __attribute__((vector_size(sizeof(Lanes))));
    constexpr Order evenPairs{0, 8, 1, 9, 4, 12, 5, 13}, oddPairs{2, 10, 3, 11, 6, 14, 7, 15};
    constexpr Order lowHalves{0, 1, 8, 9, 4, 5, 12, 13}, highHalves{2, 3, 10, 11, 6, 7, 14, 15};
    const Lanes ab = __builtin_shuffle(a, b, evenPairs) + __builtin_shuffle(a, b, oddPairs);
    const Lanes cd = __builtin_shuffle(c, d, evenPairs) + __builtin_shuffle(c, d, oddPairs);
    const Lanes all = __builtin_shuffle(ab, cd, lowHalves) + __builtin_shuffle(ab, cd, highHalves);
    for (int i = 0; i < 4; ++i)
        sums[i] = all[i] + all[i + 4];
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
void multiplyFront(const float *w, int wStride, const float *b, float *t, int p, int stride)
{
    const int width = stride / frontLanes;
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
void packFront(const float *t, int p, int stride, std::int32_t *packed, float *scale)
{
    const auto whole = [](float value) {
        return static_cast<std::int32_t>(value + (value < 0 ? -0.5f : 0.5f));
    };
    for (int k = 0; k < p; ++k, t += stride) {
        float largest = 0;
        for (int j = 0; j < stride; ++j)
            largest = std::max(largest, std::abs(t[j]));
        scale[k] = largest / packedLimit / 65536;
        const float inverse = largest > 0 ? packedLimit / largest : 0.0f;
        for (int j = 0; j < stride; j += packedLanes) {
            for (int i = j; i < j + frontLanes; ++i)
                *packed++ = (whole(t[i] * inverse) & 65535) | whole(t[i + frontLanes] * inverse) * 65536;
        }
    }
}

namespace {

//! subtractTransposed() for 16 `Vectors` entries of y and the columns of t that belong to them.
template <int Vectors>
inline void subtractColumns(const std::int32_t *t, const float *scale, int p, int words, const float *x,
                            float *y)
{
    Lanes sum[2 * Vectors];
    for (int i = 0; i < 2 * Vectors; ++i)
        sum[i] = lanes(y)[i];
    for (int k = 0; k < p; ++k, t += words) {
        const float factor = x[k] * scale[k];
        for (int i = 0; i < Vectors; ++i) {
            Lanes first, second;
            unpack(t + i * frontLanes, first, second);
            sum[2 * i] -= factor * first;
            sum[2 * i + 1] -= factor * second;
        }
    }
    for (int i = 0; i < 2 * Vectors; ++i)
        lanes(y)[i] = sum[i];
}

//! Scalar products of `Rows` neighbouring rows, w x - t z, not yet added up over the lanes.
template <int Rows>
inline void multiplyRows(const float *w, int wStride, const std::int32_t *t, const float *scale, int words,
                         const float *x, const float *z, Lanes *sum)
{
    for (int i = 0; i < Rows; ++i)
        sum[i] = Lanes{};
    for (int j = 0; j < words; j += frontLanes) {
        const Lanes firstRight = lanes(z + 2 * j)[0], secondRight = lanes(z + 2 * j)[1];
        for (int i = 0; i < Rows; ++i) {
            Lanes first, second;
            unpack(t + static_cast<std::ptrdiff_t>(i) * words + j, first, second);
            sum[i] -= first * firstRight;
            sum[i] -= second * secondRight;
        }
    }
    for (int i = 0; i < Rows; ++i)
        sum[i] *= scale[i];
    for (int j = 0; j < wStride; j += frontLanes) {
        for (int i = 0; i < Rows; ++i)
            sum[i] += *lanes(w + static_cast<std::ptrdiff_t>(i) * wStride + j) * *lanes(x + j);
    }
}

} // namespace

AUTOCUTS_CLONES
void subtractTransposed(const std::int32_t *t, const float *scale, int p, int stride, const float *x,
                        float *y)
{
    const int words = stride / 2;
    int j = 0;
    for (; j + 3 * frontLanes <= words; j += 3 * frontLanes)
        subtractColumns<3>(t + j, scale, p, words, x, y + 2 * j);
    if (words - j == 2 * frontLanes)
        subtractColumns<2>(t + j, scale, p, words, x, y + 2 * j);
    else if (words - j == frontLanes)
        subtractColumns<1>(t + j, scale, p, words, x, y + 2 * j);
}

AUTOCUTS_CLONES
void solvePivots(const float *w, int wStride, const std::int32_t *t, const float *scale, int stride, int p,
                 const float *x, const float *z, float *y)
{
    const int words = stride / 2;
    Lanes sum[4];
    int k = 0;
    for (; k + 4 <= p; k += 4) {
        multiplyRows<4>(w + static_cast<std::ptrdiff_t>(k) * wStride, wStride,
                        t + static_cast<std::ptrdiff_t>(k) * words, scale + k, words, x, z, sum);
        sumsOf(sum[0], sum[1], sum[2], sum[3], y + k);
    }
    for (; k < p; ++k) {
        multiplyRows<1>(w + static_cast<std::ptrdiff_t>(k) * wStride, wStride,
                        t + static_cast<std::ptrdiff_t>(k) * words, scale + k, words, x, z, sum);
        y[k] = sumOf(sum[0]);
    }
}

} // namespace autocuts
