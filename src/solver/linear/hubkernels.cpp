#include "solver/linear/hubkernels.h"

#include "solver/linear/simd.h"

#include <cstddef>

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

inline void gather(const float *values, const LaneInts &index, Lanes &result)
{
    for (int lane = 0; lane < laneCount; ++lane)
        result[lane] = values[index[lane]];
}

inline const float *flat(const Lanes *v)
{
    return reinterpret_cast<const float *>(v);
}

} // namespace

AUTOCUTS_CLONES
double multiplyBlocks(const LaneMatrix *hessian, const BlockSystem *systems, const CornerLinks *links,
                      const Lanes *p, const Lanes *movable, Lanes *q, int first, int end)
{
    DoubleLanes sum{};
    for (int b = first; b < end; ++b) {
        const Lanes *own = p + 6 * static_cast<std::ptrdiff_t>(b);
        Lanes result[6];
        multiplyLanes(hessian[b], own, result);
        for (int i = 0; i < 6; ++i) {
            const Lanes &w = systems[b].link[i];
            Lanes u, v;
            gather(flat(p), links[b].partner[i], u);
            gather(flat(p) + laneCount, links[b].partner[i], v);
            result[i / 2 * 2] -= w * u;
            result[i / 2 * 2 + 1] -= w * v;
        }
        Lanes *out = q + 6 * static_cast<std::ptrdiff_t>(b);
        if (movable) {
            for (int i = 0; i < 6; ++i)
                result[i] *= movable[6 * static_cast<std::ptrdiff_t>(b) + i];
        }
        Lanes part = own[0] * result[0];
        out[0] = result[0];
        for (int i = 1; i < 6; ++i) {
            part += own[i] * result[i];
            out[i] = result[i];
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
        const Lanes *own = r + 6 * static_cast<std::ptrdiff_t>(b);
        Lanes y[6];
        multiplyLanes(systems[b].inverse, own, y);
        Lanes part = own[0] * y[0];
        for (int i = 1; i < 6; ++i)
            part += own[i] * y[i];
        accumulate(part, sum);
        for (int k = 0; k < 3; ++k) {
            const Lanes u = hubs[b].star[k] * y[2 * k], v = hubs[b].star[k] * y[2 * k + 1];
            for (int lane = 0; lane < laneCount; ++lane) {
                float *load = loads + 2 * static_cast<std::ptrdiff_t>(hubs[b].place[k][lane]);
                load[0] = u[lane];
                load[1] = v[lane];
            }
        }
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
        for (int k = 0; k < 3; ++k) {
            Lanes hubU, hubV;
            for (int lane = 0; lane < laneCount; ++lane) {
                const float *place = u + 2 * static_cast<std::ptrdiff_t>(hubs[b].hub[k][lane]);
                hubU[lane] = place[0];
                hubV[lane] = place[1];
            }
            pulled[2 * k] = r[at + 2 * k] + hubs[b].star[k] * hubU;
            pulled[2 * k + 1] = r[at + 2 * k + 1] + hubs[b].star[k] * hubV;
        }
        multiplyLanes(systems[b].inverse, pulled, z);
        for (int i = 0; i < 6; ++i) {
            const Lanes free = movable ? z[i] * movable[at + i] : z[i];
            p[at + i] = free + beta * p[at + i];
        }
    }
}

AUTOCUTS_CLONES
void prepareBlocks(const CornerLinks *links, const float *pairs, const int *hubOfSlot, int hubCount,
                   const Lanes *ground, const Lanes *movable, LaneMatrix *hessian, BlockSystem *systems,
                   HubLinks *hubs, int first, int end)
{
    constexpr std::array<int, 6> diagonalEntry{0, 2, 5, 9, 14, 20};
    for (int b = first; b < end; ++b) {
        LaneMatrix &own = hessian[b];
        LaneMatrix s = own;
        Lanes trace{};
        for (const int d : diagonalEntry)
            trace += own[d];
        for (int k = 0; k < 3; ++k) {
            Lanes star{}, hold{}, sum{};
            for (int i = 2 * k; i < 2 * k + 2; ++i) {
                Lanes &w = systems[b].link[i];
                gather(pairs, links[b].pair[i], w);
                IntLanes mine, other;
                for (int lane = 0; lane < laneCount; ++lane) {
                    mine[lane] = hubs[b].hub[k][lane];
                    other[lane] = hubOfSlot[links[b].partner[i][lane]];
                }
                const IntLanes alone = (mine == hubCount) | (other == hubCount);
                const Lanes zero{};
                hold += alone ? w : zero;
                star += (mine == other) & ~alone ? w : zero;
                sum += w;
            }
            hubs[b].star[k] = star;
            for (int axis = 0; axis < 2; ++axis) {
                const int i = 2 * k + axis;
                const std::ptrdiff_t at = 6 * static_cast<std::ptrdiff_t>(b) + i;
                Lanes add = leastHold * trace + star + hold;
                Lanes onDiagonal = sum;
                if (ground) {
                    add += ground[at];
                    onDiagonal += ground[at];
                }
                if (movable)
                    add += (1 - movable[at]) * fixedHold * (trace + 1);
                s[diagonalEntry[i]] += add;
                own[diagonalEntry[i]] += onDiagonal;
            }
        }
        // Behind the last triangle there is nothing at all.
        for (const int d : diagonalEntry)
            s[d] = trace == 0 ? s[d] + 1 : s[d];
        invertLanes(s, systems[b].inverse);
    }
}

} // namespace autocuts
