// Vectors of eight floats and 4 x 4 matrix kernels for eight triangles at a time (compiler vectors, any
// processor).
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace autocuts {

//! Floats in a vector: as many as an AVX register holds.
constexpr int laneCount = 8;

//! Eight floats, one per triangle, with arithmetic on all of them at once.
using Lanes = float __attribute__((vector_size(laneCount * sizeof(float))));

//! Alignment of Lanes in memory. Given explicitly, because compilers ask for less when they compile for a
//! processor with shorter vectors, and functions compiled for different processors share data.
constexpr std::size_t laneAlignment = laneCount * sizeof(float);

template <class T>
struct LaneAllocator
{
    using value_type = T;
    LaneAllocator() = default;
    template <class U>
    explicit LaneAllocator(const LaneAllocator<U> &)
    {}
    T *allocate(std::size_t n)
    {
        return static_cast<T *>(::operator new(n * sizeof(T), std::align_val_t(laneAlignment)));
    }
    void deallocate(T *p, std::size_t) { ::operator delete(p, std::align_val_t(laneAlignment)); }
    bool operator==(const LaneAllocator &) const { return true; }
};

using LaneVector = std::vector<Lanes, LaneAllocator<Lanes>>;

//! Eight symmetric 4 x 4 matrices, one per triangle, over its edge vectors in the order u1 - u0, u2 - u0,
//! v1 - v0, v2 - v0. Lower triangles, packed row by row.
struct alignas(laneAlignment) EdgeMatrix
{
    Lanes entry[10];

    Lanes &operator[](int i) { return entry[i]; }
    const Lanes &operator[](int i) const { return entry[i]; }
};

//! Inverts eight positive definite matrices by L D L^T. A pivot of 1e-30 or less is replaced by 1e-30.
void invertLanes(const EdgeMatrix &a, EdgeMatrix &inverse);

//! y = E^T A E x for eight matrices; E maps corners (u0 v0 u1 v1 u2 v2) to edge vectors.
inline void multiplyEdges(const EdgeMatrix &a, const Lanes *x, Lanes *y)
{
    const Lanes e0 = x[2] - x[0], e1 = x[4] - x[0], e2 = x[3] - x[1], e3 = x[5] - x[1];
    y[2] = a[0] * e0 + a[1] * e1 + a[3] * e2 + a[6] * e3;
    y[4] = a[1] * e0 + a[2] * e1 + a[4] * e2 + a[7] * e3;
    y[3] = a[3] * e0 + a[4] * e1 + a[5] * e2 + a[8] * e3;
    y[5] = a[6] * e0 + a[7] * e1 + a[8] * e2 + a[9] * e3;
    y[0] = -(y[2] + y[4]);
    y[1] = -(y[3] + y[5]);
}

} // namespace autocuts
