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

//! Lower triangles of eight symmetric 6 x 6 matrices, packed row by row.
struct alignas(laneAlignment) LaneMatrix
{
    Lanes entry[21];

    Lanes &operator[](int i) { return entry[i]; }
    const Lanes &operator[](int i) const { return entry[i]; }
};

//! Inverses of eight positive definite matrices, as L D L^T. A pivot that is not positive counts as tiny.
void invertLanes(const LaneMatrix &a, LaneMatrix &inverse);

//! y = A x for eight matrices; x and y are six vectors.
inline void multiplyLanes(const LaneMatrix &a, const Lanes *x, Lanes *y)
{
    y[0] = a[0] * x[0] + a[1] * x[1] + a[3] * x[2] + a[6] * x[3] + a[10] * x[4] + a[15] * x[5];
    y[1] = a[1] * x[0] + a[2] * x[1] + a[4] * x[2] + a[7] * x[3] + a[11] * x[4] + a[16] * x[5];
    y[2] = a[3] * x[0] + a[4] * x[1] + a[5] * x[2] + a[8] * x[3] + a[12] * x[4] + a[17] * x[5];
    y[3] = a[6] * x[0] + a[7] * x[1] + a[8] * x[2] + a[9] * x[3] + a[13] * x[4] + a[18] * x[5];
    y[4] = a[10] * x[0] + a[11] * x[1] + a[12] * x[2] + a[13] * x[3] + a[14] * x[4] + a[19] * x[5];
    y[5] = a[15] * x[0] + a[16] * x[1] + a[17] * x[2] + a[18] * x[3] + a[19] * x[4] + a[20] * x[5];
}

} // namespace autocuts
