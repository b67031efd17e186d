#include "solver/newton/hubkernels.h"

#include "solver/base/simd.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace autocuts::newton {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Least stiffness that holds a triangle in place, relative to its own: without it, S could have no inverse.
constexpr float leastHold = 1e-4f;
//! How many times stiffer than its triangle a corner is held that must not move.
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

//! Splits the two Lanes in which slotOf() stores a corner of eight triangles into its two axes.
inline void takeApart(const Lanes &first, const Lanes &second, Lanes &u, Lanes &v)
{
    u = __builtin_shufflevector(first, second, 0, 2, 8, 10, 4, 6, 12, 14);
    v = __builtin_shufflevector(first, second, 1, 3, 9, 11, 5, 7, 13, 15);
}

inline void putTogether(const Lanes &u, const Lanes &v, Lanes &first, Lanes &second)
{
    first = __builtin_shufflevector(u, v, 0, 8, 1, 9, 4, 12, 5, 13);
    second = __builtin_shufflevector(u, v, 2, 10, 3, 11, 6, 14, 7, 15);
}

inline void takeApart(const Lanes *block, Lanes *axes)
{
    for (int i = 0; i < 6; i += 2)
        takeApart(block[i], block[i + 1], axes[i], axes[i + 1]);
}

//! Reads both coordinates as one double: half as many loads and stores.
inline double pairAt(const float *coordinates)
{
    double both;
    std::memcpy(&both, coordinates, sizeof both);
    return both;
}

//! A permutation that is its own inverse.
constexpr std::array<int, laneCount> placeOfLane{0, 1, 4, 5, 2, 3, 6, 7};

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

void fromSlots(const Lanes *x, float alpha, const Lanes *p, double scale, int triangles, double *coordinates,
               int first, int end)
{
    visitSlots(triangles, first, end, [&](std::ptrdiff_t slot, std::ptrdiff_t i) {
        coordinates[i] = scale * (flat(x)[slot] + alpha * flat(p)[slot]);
    });
}

AUTOCUTS_CLONES
double multiplyBlocks(const EdgeMatrix *hessian, const LinkSprings *springs, const LinkInts *partners,
                      const Lanes *p, const Lanes *ground, const Lanes *movable, Lanes *q, int first, int end)
{
    DoubleLanes sum{};
    for (int b = first; b < end; ++b) {
        const std::ptrdiff_t at = 6 * static_cast<std::ptrdiff_t>(b);
        const Lanes *w = springs[b].link;
        Lanes own[6], result[6];
        takeApart(p + at, own);
        multiplyEdges(hessian[b], own, result);
        for (int k = 0; k < 6; k += 2) {
            Lanes u1, v1, u2, v2;
            gatherPairs(flat(p), partners[b][k], u1, v1);
            gatherPairs(flat(p), partners[b][k + 1], u2, v2);
            result[k] += w[k] * (own[k] - u1) + w[k + 1] * (own[k] - u2);
            result[k + 1] += w[k] * (own[k + 1] - v1) + w[k + 1] * (own[k + 1] - v2);
        }
        Lanes part{};
        for (int i = 0; i < 6; i += 2) {
            Lanes *out = q + at + i;
            putTogether(result[i], result[i + 1], out[0], out[1]);
            for (int h = 0; h < 2; ++h) {
                if (ground)
                    out[h] += ground[at + i + h] * p[at + i + h];
                if (movable)
                    out[h] *= movable[at + i + h];
                part += p[at + i + h] * out[h];
            }
        }
        accumulate(part, sum);
    }
    return total(sum);
}

AUTOCUTS_CLONES
double advanceBlocks(float alpha, const Lanes *q, Lanes *r, int first, int end)
{
    DoubleLanes sum{};
    for (std::ptrdiff_t b = first; b < end; ++b) {
        Lanes part{};
        for (std::ptrdiff_t i = 6 * b; i < 6 * b + 6; ++i) {
            r[i] -= alpha * q[i];
            part += r[i] * r[i];
        }
        accumulate(part, sum);
    }
    return total(sum);
}

namespace {

//! y = S^-1 r.
inline void solveBlock(const BlockInverse &s, const Lanes *r, Lanes *y)
{
    Lanes moved[6], back[6];
    for (int i = 0; i < 6; ++i)
        moved[i] = s.give[i] * r[i];
    multiplyEdges(s.stiffness, moved, back);
    for (int i = 0; i < 6; ++i)
        y[i] = s.give[i] * (r[i] - back[i]);
}

} // namespace

AUTOCUTS_CLONES
double loadHubs(const BlockInverse *inverses, const CornerInts *places, const Lanes *r, float *loads,
                int first, int end)
{
    DoubleLanes sum{};
    for (int b = first; b < end; ++b) {
        Lanes own[6], y[6];
        takeApart(r + 6 * static_cast<std::ptrdiff_t>(b), own);
        solveBlock(inverses[b], own, y);
        Lanes part = own[0] * y[0];
        for (int i = 1; i < 6; ++i)
            part += own[i] * y[i];
        accumulate(part, sum);
        for (int k = 0; k < 3; ++k) {
            const Lanes &star = inverses[b].star[k];
            scatterPairs(star * y[2 * k], star * y[2 * k + 1], places[b][k], loads);
        }
    }
    return total(sum);
}

AUTOCUTS_CLONES
void pullCorners(const BlockInverse *inverses, const CornerInts *hubs, const Lanes *r, const float *u,
                 const Lanes *movable, float alpha, float beta, Lanes *x, Lanes *p, int first, int end)
{
    for (int b = first; b < end; ++b) {
        const std::ptrdiff_t at = 6 * static_cast<std::ptrdiff_t>(b);
        Lanes pulled[6], z[6];
        takeApart(r + at, pulled);
        for (int k = 0; k < 3; ++k) {
            Lanes hubU, hubV;
            gatherPairs(u, hubs[b][k], hubU, hubV);
            pulled[2 * k] += inverses[b].star[k] * hubU;
            pulled[2 * k + 1] += inverses[b].star[k] * hubV;
        }
        solveBlock(inverses[b], pulled, z);
        for (int i = 0; i < 6; i += 2) {
            Lanes zs[2];
            putTogether(z[i], z[i + 1], zs[0], zs[1]);
            for (int h = 0; h < 2; ++h) {
                const std::ptrdiff_t c = at + i + h;
                const Lanes free = movable ? zs[h] * movable[c] : zs[h];
                if (beta == 0) {
                    p[c] = free;
                    x[c] = Lanes{};
                    continue;
                }
                x[c] += alpha * p[c];
                p[c] = free + beta * p[c];
            }
        }
    }
}

namespace {

//! Computes C of BlockInverse from K.
inline void stiffen(const EdgeMatrix &k, const Lanes *give, EdgeMatrix &c)
{
    // E diag(give) E^T = U^T D U per axis, U = [1 turn; 0 1]: with K' = U K U^T and T = (K' + D^-1)^-1,
    // U C U^T = (K'^-1 + D)^-1 = K' T D^-1 = D^-1 - D^-1 T D^-1. The first form is accurate where the
    // triangle is soft compared with the springs that hold it, the second where it is stiff.
    Lanes turn[2], hold[4]; // hold = D^-1
    for (int axis = 0; axis < 2; ++axis) {
        const Lanes a = give[axis], b = give[2 + axis], e = give[4 + axis];
        const Lanes sum = a + b;
        turn[axis] = a / sum;
        hold[2 * axis] = 1 / sum;
        hold[2 * axis + 1] = 1 / (e + turn[axis] * b);
    }
    const auto shear = [](const Lanes &tu, const Lanes &tv, const EdgeMatrix &from, EdgeMatrix &to) {
        to[2] = from[2];
        to[1] = from[1] + tu * from[2];
        to[0] = from[0] + tu * (from[1] + to[1]);
        to[7] = from[7];
        to[4] = from[4] + tv * from[7];
        to[6] = from[6] + tu * from[7];
        to[3] = from[3] + tu * from[4] + tv * to[6];
        to[9] = from[9];
        to[8] = from[8] + tv * from[9];
        to[5] = from[5] + tv * (from[8] + to[8]);
    };
    EdgeMatrix sheared, held, t, result;
    shear(turn[0], turn[1], k, sheared);
    held = sheared;
    constexpr std::array<int, 4> diagonalEntry{0, 2, 5, 9};
    Lanes softness{}; // trace of K' D
    for (int i = 0; i < 4; ++i) {
        held[diagonalEntry[i]] += hold[i];
        softness += sheared[diagonalEntry[i]] / hold[i];
    }
    invertLanes(held, t);
    const auto entry = [](const EdgeMatrix &m, int i, int j) -> const Lanes & {
        return i < j ? m[j * (j + 1) / 2 + i] : m[i * (i + 1) / 2 + j];
    };
    int at = 0;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j <= i; ++j, ++at) {
            Lanes soft = entry(sheared, i, 0) * entry(t, 0, j);
            for (int m = 1; m < 4; ++m)
                soft += entry(sheared, i, m) * entry(t, m, j);
            const Lanes less = hold[i] * t[at];
            const Lanes stiff = i == j ? hold[i] * (1 - less) : -less * hold[j];
            result[at] = softness < 1 ? soft * hold[j] : stiff;
        }
    }
    shear(-turn[0], -turn[1], result, c);
}

} // namespace

AUTOCUTS_CLONES
void prepareBlocks(const EdgeMatrix *hessian, const LinkInts *pairNumbers, const LinkKinds *kinds,
                   const float *pairs, const Lanes *ground, const Lanes *movable, LinkSprings *springs,
                   BlockInverse *inverses, int first, int end)
{
    const Lanes zero{};
    for (int b = first; b < end; ++b) {
        const std::ptrdiff_t at = 6 * static_cast<std::ptrdiff_t>(b);
        const EdgeMatrix &own = hessian[b];
        // Trace over the corners; zero after the last triangle.
        const Lanes trace = 2 * (own[0] + own[1] + own[2] + own[5] + own[8] + own[9]);
        const Lanes least = trace == 0 ? zero + 1 : leastHold * trace;
        Lanes grounds[6]{}, moves[6];
        if (ground)
            takeApart(ground + at, grounds);
        if (movable)
            takeApart(movable + at, moves);
        IntLanes within, holding;
        load(kinds[b].within, within);
        load(kinds[b].holding, holding);
        for (int k = 0; k < 3; ++k) {
            Lanes star{}, hold = least;
            for (int i = 2 * k; i < 2 * k + 2; ++i) {
                Lanes &w = springs[b].link[i];
                gather(pairs, pairNumbers[b][i], w);
                star += (within & 1 << i) != 0 ? w : zero;
                hold += (holding & 1 << i) != 0 ? w : zero;
            }
            inverses[b].star[k] = star;
            for (int i = 2 * k; i < 2 * k + 2; ++i) {
                Lanes all = star + hold + grounds[i];
                if (movable)
                    all += (1 - moves[i]) * fixedHold * (trace + 1);
                inverses[b].give[i] = 1 / all;
            }
        }
        stiffen(own, inverses[b].give, inverses[b].stiffness);
    }
}

} // namespace autocuts::newton
