// Eight triangles at a time: 6 x 6 kernels over vectors of eight floats (compiler vectors, any processor).
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace autocuts {

constexpr int laneCount = 8;

//! Eight floats that are added and multiplied together.
using Lanes = float __attribute__((vector_size(laneCount * sizeof(float))));

//! What Lanes are aligned to. Compilers ask for less where the processor they compile for has shorter
//! vectors, but functions compiled for several processors meet in memory.
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

//! Eight symmetric 4 x 4 matrices over the edge vectors of as many triangles, in the order u1 - u0, u2 - u0,
//! v1 - v0, v2 - v0. Lower triangles, packed row by row.
struct alignas(laneAlignment) EdgeMatrix
{
    Lanes entry[10];

    Lanes &operator[](int i) { return entry[i]; }
    const Lanes &operator[](int i) const { return entry[i]; }
};

//! Inverses of eight positive definite matrices, as L D L^T. A pivot that is not positive counts as tiny.
void invertLanes(const EdgeMatrix &a, EdgeMatrix &inverse);

//! y = E^T A E x for eight matrices, E the map from corners (u0 v0 u1 v1 u2 v2) to edge vectors.
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
