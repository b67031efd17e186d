#include "solver/linear/frontkernels.h"

#include "solver/base/simd.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace autocuts::linear {

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

using WholeLanes = std::int32_t __attribute__((vector_size(frontLanes * sizeof(std::int32_t)), may_alias));

//! Sixteen entries of a packed row.
inline void unpack(const std::int32_t *p, Lanes &first, Lanes &second)
{
    const WholeLanes both = *reinterpret_cast<const WholeLanes *>(p);
    first = reinterpret_cast<Lanes>(both << 16);
    second = reinterpret_cast<Lanes>(both & -65536);
}

inline float sumOf(const Lanes &v)
{
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

//! Sums over the lanes of four vectors at once, each added in the order of sumOf().
inline void sumsOf(const Lanes &a, const Lanes &b, const Lanes &c, const Lanes &d, float *sums)
{
    const Lanes ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13) +
                     __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Lanes cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13) +
                     __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    const Lanes all = __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13) +
                      __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15);
    for (int i = 0; i < 4; ++i)
        sums[i] = all[i] + all[i + 4];
}

} // namespace

namespace {

using LaneNumbers = std::int32_t __attribute__((vector_size(frontLanes * sizeof(std::int32_t))));

//! invertFront() for rows of `Width` vectors.
template <int Width>
inline bool invertRows(float *a, int n, int stride, float smallest)
{
    constexpr LaneNumbers number{0, 1, 2, 3, 4, 5, 6, 7};
    // Gauss-Jordan elimination without pivoting, which positive definite matrices do not need.
    for (int k = 0; k < n; ++k) {
        float *row = a + static_cast<std::ptrdiff_t>(k) * stride;
        const float pivot = row[k];
        if (!(pivot > smallest))
            return false;
        const float inverse = 1 / pivot;
        // Column k: the pivot becomes its inverse, the other entries start at zero. Done by masks: when a
        // single float is written and then read at once as part of a vector, the processor stalls.
        LaneNumbers own[Width];
        Lanes scaled[Width];
        for (int j = 0; j < Width; ++j) {
            own[j] = number == k - j * frontLanes;
            scaled[j] = inverse * (own[j] ? Lanes{} + 1 : lanes(row)[j]);
        }
        for (int i = 0; i < n; ++i) {
            if (i == k)
                continue;
            float *other = a + static_cast<std::ptrdiff_t>(i) * stride;
            const float factor = other[k];
            for (int j = 0; j < Width; ++j)
                lanes(other)[j] = (own[j] ? Lanes{} : lanes(other)[j]) - factor * scaled[j];
        }
        for (int j = 0; j < Width; ++j)
            lanes(row)[j] = scaled[j];
    }
    return true;
}

} // namespace

AUTOCUTS_CLONES
bool invertFront(float *a, int n, int stride, float smallest)
{
    switch (paddedRow(n) / frontLanes) {
    case 1:
        return invertRows<1>(a, n, stride, smallest);
    case 2:
        return invertRows<2>(a, n, stride, smallest);
    case 3:
        return invertRows<3>(a, n, stride, smallest);
    default:
        return invertRows<4>(a, n, stride, smallest);
    }
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
        // From the diagonal on, in pairs of vectors where possible.
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
            lanes(out)[j] = -s00;
            lanes(out)[j + 1] = -s01;
            lanes(out + step)[j] = -s10;
            lanes(out + step)[j + 1] = -s11;
            lanes(out + 2 * step)[j] = -s20;
            lanes(out + 2 * step)[j + 1] = -s21;
            lanes(out + 3 * step)[j] = -s30;
            lanes(out + 3 * step)[j + 1] = -s31;
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
            lanes(out)[j] = -s0;
            lanes(out + step)[j] = -s1;
            lanes(out + 2 * step)[j] = -s2;
            lanes(out + 3 * step)[j] = -s3;
        }
    }
    for (; i < r; ++i) {
        for (int j = i / frontLanes; j < width; ++j) {
            Lanes sum{};
            for (int k = 0; k < p; ++k)
                sum += b[static_cast<std::ptrdiff_t>(k) * stride + i] *
                       lanes(t + static_cast<std::ptrdiff_t>(k) * stride)[j];
            lanes(c + static_cast<std::ptrdiff_t>(i) * cStride)[j] = -sum;
        }
    }
}

namespace {

using TwoLanes = float __attribute__((vector_size(2 * sizeof(float))));
using FourLanes = float __attribute__((vector_size(4 * sizeof(float))));
using EightLanes = float __attribute__((vector_size(8 * sizeof(float))));

//! to += from for as many floats as a Vector holds, at any address.
template <class Vector>
inline void addFloats(const float *from, float *to)
{
    Vector more, sum;
    std::memcpy(&more, from, sizeof more);
    std::memcpy(&sum, to, sizeof sum);
    sum += more;
    std::memcpy(to, &sum, sizeof sum);
}

//! to += from for `count` floats, an even number.
inline void addRow(const float *from, float *to, int count)
{
    int j = 0;
    for (; j + 8 <= count; j += 8)
        addFloats<EightLanes>(from + j, to + j);
    if (j + 4 <= count) {
        addFloats<FourLanes>(from + j, to + j);
        j += 4;
    }
    if (j < count)
        addFloats<TwoLanes>(from + j, to + j);
}

} // namespace

AUTOCUTS_CLONES
void addUpdate(const float *update, int stride, const FrontRun *runs, int first, int end, int count,
               int pivots, float *inPivots, int pivotStride, float *inRows, int rowStride)
{
    for (int r = first; r < end; ++r) {
        for (int i = runs[r].begin; i < runs[r].end; ++i) {
            const float *line = update + static_cast<std::ptrdiff_t>(i) * stride;
            const int row = runs[r].place + i - runs[r].begin;
            float *const pivotLine = inPivots + static_cast<std::ptrdiff_t>(row) * pivotStride;
            const std::ptrdiff_t rowBegin = static_cast<std::ptrdiff_t>(row) * rowStride; // in inRows
            const int diagonal = i - i % 2 - runs[r].begin; // column at which the row's node begins
            for (int q = r; q < count; ++q) {
                const FrontRun &run = runs[q];
                const int skip = q == r ? diagonal : 0;
                float *target =
                    run.place < pivots ? pivotLine + run.place : inRows + (rowBegin + run.place - pivots);
                addRow(line + run.begin + skip, target + skip, run.end - run.begin - skip);
            }
        }
    }
}

AUTOCUTS_CLONES
void packFront(const float *t, int p, int stride, std::int32_t *packed)
{
    const auto bits = [](float value) {
        std::uint32_t result;
        std::memcpy(&result, &value, sizeof result);
        return result;
    };
    for (std::ptrdiff_t j = 0; j < static_cast<std::ptrdiff_t>(p) * stride; j += packedLanes) {
        for (std::ptrdiff_t i = j; i < j + frontLanes; ++i) {
            const std::uint32_t first = (bits(t[i]) + 0x8000) >> 16;
            const std::uint32_t second = (bits(t[i + frontLanes]) + 0x8000) & 0xffff0000;
            *packed++ = static_cast<std::int32_t>(second | first);
        }
    }
}

namespace {

//! Entries of t^T x for 16 * `Vectors` columns of t.
template <int Vectors>
inline void transposedColumns(const std::int32_t *t, int p, int words, const float *x, float *y)
{
    Lanes sum[2 * Vectors]{};
    for (int k = 0; k < p; ++k, t += words) {
        const float factor = x[k];
        for (int i = 0; i < Vectors; ++i) {
            Lanes first, second;
            unpack(t + i * frontLanes, first, second);
            sum[2 * i] += factor * first;
            sum[2 * i + 1] += factor * second;
        }
    }
    for (int i = 0; i < 2 * Vectors; ++i)
        lanes(y)[i] = sum[i];
}

//! Scalar products for `Rows` adjacent rows, w x - t z, before summing over the lanes.
template <int Rows>
inline void multiplyRows(const float *w, int wStride, const std::int32_t *t, int words, const float *x,
                         const float *z, Lanes *sum)
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
    for (int j = 0; j < wStride; j += frontLanes) {
        for (int i = 0; i < Rows; ++i)
            sum[i] += *lanes(w + static_cast<std::ptrdiff_t>(i) * wStride + j) * *lanes(x + j);
    }
}

//! Copies both scalars of a node at once.
inline void copyNode(const float *from, float *to)
{
    std::memcpy(to, from, 2 * sizeof(float));
}

inline void subtractNode(const float *from, float *to)
{
    TwoLanes less, all;
    std::memcpy(&less, from, sizeof less);
    std::memcpy(&all, to, sizeof all);
    all -= less;
    std::memcpy(to, &all, sizeof all);
}

template <class T>
inline void fetch(const T *begin, std::ptrdiff_t count)
{
    constexpr std::ptrdiff_t cacheLine = 64 / sizeof(T);
    for (std::ptrdiff_t i = 0; i < count; i += cacheLine)
        __builtin_prefetch(begin + i);
}

} // namespace

AUTOCUTS_CLONES
void solveForward(const PackedFront *fronts, int first, int end, float *x, float *outside, float *scratch)
{
    for (int n = first; n < end; ++n) {
        const PackedFront &f = fronts[n];
        const float *own = x + f.first;
        const int words = f.stride / 2;
        int j = 0;
        for (; j + 3 * frontLanes <= words; j += 3 * frontLanes)
            transposedColumns<3>(f.coupling + j, f.pivots, words, own, scratch + 2 * j);
        if (words - j == 2 * frontLanes)
            transposedColumns<2>(f.coupling + j, f.pivots, words, own, scratch + 2 * j);
        else if (words - j == frontLanes)
            transposedColumns<1>(f.coupling + j, f.pivots, words, own, scratch + 2 * j);
        for (int i = 0; i < f.inside; ++i)
            subtractNode(scratch + 2 * i, x + 2 * static_cast<std::ptrdiff_t>(f.numbers[i]));
        for (int i = f.inside; i < f.rows; ++i)
            subtractNode(scratch + 2 * i, outside + 2 * static_cast<std::ptrdiff_t>(f.outside[i - f.inside]));
    }
}

AUTOCUTS_CLONES
void solveBackward(const PackedFront *fronts, int first, int end, int prefetchAhead, float *x, float *scratch)
{
    alignas(Lanes) float own[largestFront] = {}, solved[largestFront];
    for (int n = end - 1; n >= first; --n) {
        if (prefetchAhead > 0 && n >= prefetchAhead) {
            // The processor does not predict a backward walk by itself.
            const PackedFront &next = fronts[n - prefetchAhead];
            fetch(next.inverse, static_cast<std::ptrdiff_t>(next.pivots) * next.pivotStride);
            fetch(next.coupling, static_cast<std::ptrdiff_t>(next.pivots) * next.stride / 2);
        }
        const PackedFront &f = fronts[n];
        const int words = f.stride / 2;
        // After the last row t holds zeros, which must not be multiplied by values that are not numbers.
        if (words > 0)
            lanes(scratch + f.stride)[-2] = lanes(scratch + f.stride)[-1] = Lanes{};
        for (int i = 0; i < f.rows; ++i)
            copyNode(x + 2 * static_cast<std::ptrdiff_t>(f.numbers[i]), scratch + 2 * i);
        lanes(own + f.pivotStride)[-1] = Lanes{};
        for (int i = 0; i < f.pivots; i += 2)
            copyNode(x + f.first + i, own + i);
        Lanes sum[4];
        int k = 0;
        for (; k + 4 <= f.pivots; k += 4) {
            multiplyRows<4>(f.inverse + static_cast<std::ptrdiff_t>(k) * f.pivotStride, f.pivotStride,
                            f.coupling + static_cast<std::ptrdiff_t>(k) * words, words, own, scratch, sum);
            sumsOf(sum[0], sum[1], sum[2], sum[3], solved + k);
        }
        if (k < f.pivots) {
            multiplyRows<2>(f.inverse + static_cast<std::ptrdiff_t>(k) * f.pivotStride, f.pivotStride,
                            f.coupling + static_cast<std::ptrdiff_t>(k) * words, words, own, scratch, sum);
            solved[k] = sumOf(sum[0]);
            solved[k + 1] = sumOf(sum[1]);
        }
        for (int i = 0; i < f.pivots; i += 2)
            copyNode(solved + i, x + f.first + i);
    }
}

} // namespace autocuts::linear
