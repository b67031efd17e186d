#include "solver/linear/hubkernels.h"

#include "solver/linear/simd.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace autocuts {

namespace {

//! What a triangle is held by at least, in shares of its own stiffness: without it, M could not be inverted.
constexpr float leastHold = 1e-4f;
//! How much stiffer than its triangle a corner is held that must not move.
constexpr float fixedHold = 1e6f;

using DoubleLanes = double __attribute__((vector_size(laneCount * sizeof(double))));
using IntLanes = int __attribute__((vector_size(laneCount * sizeof(int))));

inline void accumulate(const Lanes &part, DoubleLanes &sum)
{
    sum += __builtin_convertvector(part, DoubleLanes);
}

inline double total(const DoubleLanes &sum)
{
    return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

inline void load(const LaneInts &values, IntLanes &result)
{
    std::memcpy(&result, values.data(), sizeof result);
}

inline void gather(const float *values, const LaneInts &index, Lanes &result)
{
    for (int lane = 0; lane < laneCount; ++lane)
        result[lane] = values[index[lane]];
}

inline const float *flat(const Lanes *v)
{
    return reinterpret_cast<const float *>(v);
}

//! Four corners' coordinates: u v u v ...
using Pairs = double __attribute__((vector_size(sizeof(Lanes))));
using Order = int __attribute__((vector_size(sizeof(Lanes))));

//! The two axes of a corner of eight triangles, out of the two Lanes in which slotOf() puts them.
inline void takeApart(const Lanes &first, const Lanes &second, Lanes &u, Lanes &v)
{
    u = __builtin_shuffle(first, second, Order{0, 2, 8, 10, 4, 6, 12, 14});
    v = __builtin_shuffle(first, second, Order{1, 3, 9, 11, 5, 7, 13, 15});
}

inline void putTogether(const Lanes &u, const Lanes &v, Lanes &first, Lanes &second)
{
    first = __builtin_shuffle(u, v, Order{0, 8, 1, 9, 4, 12, 5, 13});
    second = __builtin_shuffle(u, v, Order{2, 10, 3, 11, 6, 14, 7, 15});
}

inline void takeApart(const Lanes *block, Lanes *axes)
{
    for (int i = 0; i < 6; i += 2)
        takeApart(block[i], block[i + 1], axes[i], axes[i + 1]);
}

//! Both coordinates move as one double: half as many loads and stores.
inline double pairAt(const float *coordinates)
{
    double both;
    std::memcpy(&both, coordinates, sizeof both);
    return both;
}

constexpr std::array<int, laneCount> placeOfLane{0, 1, 4, 5, 2, 3, 6, 7}; //!< which is its own inverse

inline void gatherPairs(const float *values, const LaneInts &slot, Lanes &u, Lanes &v)
{
    const Pairs first{pairAt(values + slot[0]), pairAt(values + slot[1]), pairAt(values + slot[4]),
                      pairAt(values + slot[5])};
    const Pairs second{pairAt(values + slot[2]), pairAt(values + slot[3]), pairAt(values + slot[6]),
                       pairAt(values + slot[7])};
    takeApart(reinterpret_cast<Lanes>(first), reinterpret_cast<Lanes>(second), u, v);
}

inline void scatterPairs(const Lanes &u, const Lanes &v, const LaneInts &slot, float *values)
{
    Lanes half[2];
    putTogether(u, v, half[0], half[1]);
    for (int i = 0; i < laneCount; ++i) {
        const double both = reinterpret_cast<Pairs>(half[i / 4])[i % 4];
        std::memcpy(values + slot[placeOfLane[i]], &both, sizeof both);
    }
}

//! Calls visit(float at the slot, coordinate) for all coordinates of blocks first to end.
template <class Visit>
inline void visitSlots(int triangles, int first, int end, Visit &&visit)
{
    for (int t = first * laneCount; t < std::min(triangles, end * laneCount); ++t) {
        const std::ptrdiff_t slot = slotOf(3 * t), coordinate = 6 * static_cast<std::ptrdiff_t>(t);
        for (int k = 0; k < 3; ++k) {
            visit(slot + 2 * laneCount * k, coordinate + 2 * k);
            visit(slot + 2 * laneCount * k + 1, coordinate + 2 * k + 1);
        }
    }
}

} // namespace

int slotOf(int corner)
{
    const int t = corner / 3;
    return ((t / laneCount * 3 + corner % 3) * laneCount + placeOfLane[t % laneCount]) * 2;
}

void toSlots(const double *coordinates, double scale, int triangles, Lanes *slots, int first, int end)
{
    float *to = reinterpret_cast<float *>(slots);
    visitSlots(triangles, first, end, [&](std::ptrdiff_t slot, std::ptrdiff_t i) {
        to[slot] = static_cast<float>(scale * coordinates[i]);
    });
}

void fromSlots(const Lanes *slots, double scale, int triangles, double *coordinates, int first, int end)
{
    visitSlots(triangles, first, end,
               [&](std::ptrdiff_t slot, std::ptrdiff_t i) { coordinates[i] = scale * flat(slots)[slot]; });
}

AUTOCUTS_CLONES
double multiplyBlocks(const LaneMatrix *hessian, const BlockSystem *systems, const CornerLinks *links,
                      const Lanes *p, const Lanes *movable, Lanes *q, int first, int end)
{
    DoubleLanes sum{};
    for (int b = first; b < end; ++b) {
        const std::ptrdiff_t at = 6 * static_cast<std::ptrdiff_t>(b);
        Lanes own[6], result[6];
        takeApart(p + at, own);
        multiplyLanes(hessian[b], own, result);
        for (int i = 0; i < 6; ++i) {
            const Lanes &w = systems[b].link[i];
            Lanes u, v;
            gatherPairs(flat(p), links[b].partner[i], u, v);
            result[i / 2 * 2] -= w * u;
            result[i / 2 * 2 + 1] -= w * v;
        }
        Lanes part{};
        for (int i = 0; i < 6; i += 2) {
            Lanes *out = q + at + i;
            putTogether(result[i], result[i + 1], out[0], out[1]);
            if (movable) {
                out[0] *= movable[at + i];
                out[1] *= movable[at + i + 1];
            }
            part += p[at + i] * out[0];
            part += p[at + i + 1] * out[1];
        }
        accumulate(part, sum);
    }
    return total(sum);
}

AUTOCUTS_CLONES
double advanceBlocks(float alpha, const Lanes *p, const Lanes *q, Lanes *x, Lanes *r, int first, int end)
{
    DoubleLanes sum{};
    for (std::ptrdiff_t b = first; b < end; ++b) {
        Lanes part{};
        for (std::ptrdiff_t i = 6 * b; i < 6 * b + 6; ++i) {
            x[i] += alpha * p[i];
            r[i] -= alpha * q[i];
            part += r[i] * r[i];
        }
        accumulate(part, sum);
    }
    return total(sum);
}

AUTOCUTS_CLONES
double loadHubs(const BlockSystem *systems, const HubLinks *hubs, const Lanes *r, float *loads, int first,
                int end)
{
    DoubleLanes sum{};
    for (int b = first; b < end; ++b) {
        Lanes own[6], y[6];
        takeApart(r + 6 * static_cast<std::ptrdiff_t>(b), own);
        multiplyLanes(systems[b].inverse, own, y);
        Lanes part = own[0] * y[0];
        for (int i = 1; i < 6; ++i)
            part += own[i] * y[i];
        accumulate(part, sum);
        for (int k = 0; k < 3; ++k)
            scatterPairs(hubs[b].star[k] * y[2 * k], hubs[b].star[k] * y[2 * k + 1], hubs[b].place[k], loads);
    }
    return total(sum);
}

AUTOCUTS_CLONES
void pullCorners(const BlockSystem *systems, const HubLinks *hubs, const Lanes *r, const float *u,
                 const Lanes *movable, float beta, Lanes *p, int first, int end)
{
    for (int b = first; b < end; ++b) {
        const std::ptrdiff_t at = 6 * static_cast<std::ptrdiff_t>(b);
        Lanes pulled[6], z[6];
        takeApart(r + at, pulled);
        for (int k = 0; k < 3; ++k) {
            Lanes hubU, hubV;
            gatherPairs(u, hubs[b].hub[k], hubU, hubV);
            pulled[2 * k] += hubs[b].star[k] * hubU;
            pulled[2 * k + 1] += hubs[b].star[k] * hubV;
        }
        multiplyLanes(systems[b].inverse, pulled, z);
        for (int i = 0; i < 6; i += 2) {
            Lanes *out = p + at + i;
            Lanes zs[2];
            putTogether(z[i], z[i + 1], zs[0], zs[1]);
            for (int h = 0; h < 2; ++h) {
                const Lanes free = movable ? zs[h] * movable[at + i + h] : zs[h];
                out[h] = beta == 0 ? free : free + beta * out[h];
            }
        }
    }
}

AUTOCUTS_CLONES
void prepareBlocks(const CornerLinks *links, const float *pairs, const Lanes *ground, const Lanes *movable,
                   LaneMatrix *hessian, BlockSystem *systems, HubLinks *hubs, int first, int end)
{
    constexpr std::array<int, 6> diagonalEntry{0, 2, 5, 9, 14, 20};
    const Lanes zero{};
    for (int b = first; b < end; ++b) {
        const std::ptrdiff_t at = 6 * static_cast<std::ptrdiff_t>(b);
        LaneMatrix &own = hessian[b];
        LaneMatrix s = own;
        Lanes trace{}, grounds[6]{}, moves[6];
        for (const int d : diagonalEntry)
            trace += own[d];
        if (ground)
            takeApart(ground + at, grounds);
        if (movable)
            takeApart(movable + at, moves);
        IntLanes within, holding;
        load(hubs[b].within, within);
        load(hubs[b].holding, holding);
        for (int k = 0; k < 3; ++k) {
            Lanes star{}, hold{}, sum{};
            for (int i = 2 * k; i < 2 * k + 2; ++i) {
                Lanes &w = systems[b].link[i];
                gather(pairs, links[b].pair[i], w);
                star += (within & 1 << i) != 0 ? w : zero;
                hold += (holding & 1 << i) != 0 ? w : zero;
                sum += w;
            }
            hubs[b].star[k] = star;
            for (int i = 2 * k; i < 2 * k + 2; ++i) {
                Lanes add = leastHold * trace + star + hold + grounds[i];
                if (movable)
                    add += (1 - moves[i]) * fixedHold * (trace + 1);
                s[diagonalEntry[i]] += add;
                own[diagonalEntry[i]] += sum + grounds[i];
            }
        }
        // Behind the last triangle there is nothing at all.
        for (const int d : diagonalEntry)
            s[d] = trace == 0 ? s[d] + 1 : s[d];
        invertLanes(s, systems[b].inverse);
    }
}

} // namespace autocuts
