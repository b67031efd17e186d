// Vector loops of the conjugate gradients with hubs: eight triangles at a time. The functions have many
// parameters because they are loops over plain arrays, for a range of blocks each.
#pragma once

#include "solver/base/lanes.h"

#include <array>
#include <vector>

namespace autocuts::newton {

using LaneInts = std::array<int, laneCount>;

//! Position of a corner's u in a vector of coordinates read as floats; its v comes next. Eight triangles take
//! six Lanes, two per corner, in an order from which one shuffle per axis extracts u and v.
int slotOf(int corner);

//! Copies the coordinates of all corners, times `scale`, to the layout of slotOf(). fromSlots() copies
//! x + alpha p back.
//! \param triangles number of triangles; the last block may have fewer than eight
void toSlots(const double *coordinates, double scale, int triangles, Lanes *slots, int first, int end);
void fromSlots(const Lanes *x, float alpha, const Lanes *p, double scale, int triangles, double *coordinates,
               int first, int end);

//! Data of the links of eight triangles: entry 2 k + side belongs to side 0 or 1 of corner k. A *link* is
//! what a corner pair is to one of its two corners.
using LinkInts = std::array<LaneInts, 6>;
//! Data of the corners of eight triangles, one entry per corner.
using CornerInts = std::array<LaneInts, 3>;

//! Kinds of the links of eight triangles.
struct LinkKinds
{
    LaneInts within;  //!< bit 2 k + side: the link is to a corner of the same hub
    LaneInts holding; //!< bit 2 k + side: at least one end of the link has no hub
};

//! Links that never change. Separate arrays, because each loop reads only some of them.
struct CornerLinks
{
    std::vector<LinkInts> partner; //!< slot of the partner; the own slot at a border
    std::vector<LinkInts> pair;    //!< the corner pair; at a border the number of pairs (weight zero)
};

//! Hubs of the corners; changes with the groups.
struct HubLinks
{
    std::vector<CornerInts> hub;   //!< twice the hub's number; without a hub: that of one that does not move
    std::vector<CornerInts> place; //!< twice the corner's position in the list ordered by hubs
    std::vector<LinkKinds> kind;
};

//! Spring constants to the partners of the corners of eight triangles.
struct alignas(laneAlignment) LinkSprings
{
    Lanes link[6];
};

//! S^-1 for eight triangles: S = E^T K E + diag(1 / give) over their corners, K over the edge vectors, has
//! the inverse diag(give) - diag(give) E^T C E diag(give) with C = (K^-1 + E diag(give) E^T)^-1.
struct alignas(laneAlignment) BlockInverse
{
    EdgeMatrix stiffness; //!< C
    Lanes give[6];        //!< displacement under a unit load when held by its springs alone
    Lanes star[3];        //!< spring constant between corner and hub
};

//! Computes q = H p for blocks first to end.
//! \param ground added to the diagonal; null when there is none
//! \param movable 0 or 1 per coordinate; null when all are 1. Both in the layout of p
//! \return p . q over these blocks
double multiplyBlocks(const EdgeMatrix *hessian, const LinkSprings *springs, const LinkInts *partners,
                      const Lanes *p, const Lanes *ground, const Lanes *movable, Lanes *q, int first,
                      int end);

//! Computes r -= alpha q.
//! \return r . r
double advanceBlocks(float alpha, const Lanes *q, Lanes *r, int first, int end);

//! Computes the loads of the corners on their hubs, star * y with y = S^-1 r.
//! \return r . y
double loadHubs(const BlockInverse *inverses, const CornerInts *places, const Lanes *r, float *loads,
                int first, int end);

//! Computes x += alpha p and p = z + beta p with z = S^-1 (r + star * u), u the positions of the hubs. x and
//! p are not read when beta is 0.
void pullCorners(const BlockInverse *inverses, const CornerInts *hubs, const Lanes *r, const float *u,
                 const Lanes *movable, float alpha, float beta, Lanes *x, Lanes *p, int first, int end);

//! Fills the springs and the inverses of blocks first to end.
//! \param pairs spring constant per corner pair, and a zero for borders
void prepareBlocks(const EdgeMatrix *hessian, const LinkInts *pairNumbers, const LinkKinds *kinds,
                   const float *pairs, const Lanes *ground, const Lanes *movable, LinkSprings *springs,
                   BlockInverse *inverses, int first, int end);

} // namespace autocuts::newton
