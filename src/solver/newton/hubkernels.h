// The vector loops of the conjugate gradients with hubs: eight triangles at a time.
// The functions have many parameters because they are loops over plain arrays, a range of blocks each.
#pragma once

#include "solver/base/lanes.h"

#include <array>
#include <vector>

namespace autocuts::newton {

using LaneInts = std::array<int, laneCount>;

//! Where a corner's u lies in a vector of coordinates, read as floats; its v is the next one. Six Lanes per
//! eight triangles, two per corner, in an order that one shuffle per axis takes apart.
int slotOf(int corner);

//! Coordinates of all corners, in their order, to the layout of slotOf(), times `scale`; and back, those of
//! x + alpha p. \param triangles how many there are; the last block may have fewer than eight
void toSlots(const double *coordinates, double scale, int triangles, Lanes *slots, int first, int end);
void fromSlots(const Lanes *x, float alpha, const Lanes *p, double scale, int triangles, double *coordinates,
               int first, int end);

//! For the two sides of each of eight triangles' corners (2 k + side), what belongs to the link there.
using LinkInts = std::array<LaneInts, 6>;
//! For each of the three corners of eight triangles.
using CornerInts = std::array<LaneInts, 3>;

//! How the corners of eight triangles hang together with others.
struct LinkKinds
{
    LaneInts within;  //!< bit 2 k + side: the link is to a corner of the same hub
    LaneInts holding; //!< bit 2 k + side: at least one end of the link is on its own
};

//! What never changes: kept apart, because each loop reads only some of it.
struct CornerLinks
{
    std::vector<LinkInts> partner; //!< the partner's slot, the own one at a border
    std::vector<LinkInts> pair;    //!< the corner pair; at a border their number (an entry without weight)
};

//! How corners hang on hubs; changes with the groups.
struct HubLinks
{
    std::vector<CornerInts> hub;   //!< twice the number of the hub; for a corner on its own, of one at rest
    std::vector<CornerInts> place; //!< twice the place of the corner in the list that is ordered by hubs
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
    Lanes give[6];        //!< per coordinate: what a unit load moves it by, held by its springs alone
    Lanes star[3];        //!< spring constant between corner and hub
};

//! q = H p for blocks first to end; returns p . q over them.
//! \param ground added to the diagonal; in the layout of p, as `movable`: 0 or 1. Both null when there is
//! none
double multiplyBlocks(const EdgeMatrix *hessian, const LinkSprings *springs, const LinkInts *partners,
                      const Lanes *p, const Lanes *ground, const Lanes *movable, Lanes *q, int first,
                      int end);

//! r -= alpha q; returns r . r.
double advanceBlocks(float alpha, const Lanes *q, Lanes *r, int first, int end);

//! Loads of the corners on their hubs: star * y with y = S^-1 r; returns r . y.
double loadHubs(const BlockInverse *inverses, const CornerInts *places, const Lanes *r, float *loads,
                int first, int end);

//! x += alpha p, p = z + beta p with z = S^-1 (r + star * u), u the places of the hubs; x and p are not read
//! when beta is 0.
void pullCorners(const BlockInverse *inverses, const CornerInts *hubs, const Lanes *r, const float *u,
                 const Lanes *movable, float alpha, float beta, Lanes *x, Lanes *p, int first, int end);

//! Fills the springs and the inverses of blocks first to end. \param pairs spring constant per corner pair,
//! and a zero
void prepareBlocks(const EdgeMatrix *hessian, const LinkInts *pairNumbers, const LinkKinds *kinds,
                   const float *pairs, const Lanes *ground, const Lanes *movable, LinkSprings *springs,
                   BlockInverse *inverses, int first, int end);

} // namespace autocuts::newton
