// The vector loops of the conjugate gradients with hubs: eight triangles at a time.
#pragma once

#include "solver/linear/lanes.h"

#include <array>

namespace autocuts {

using LaneInts = std::array<int, laneCount>;

//! Where a corner's u lies in a vector of coordinates, read as floats; its v is the next one. Six Lanes per
//! eight triangles, two per corner, in an order that one shuffle per axis takes apart.
int slotOf(int corner);

//! Coordinates of all corners, in their order, to the layout of slotOf() and back, times `scale`.
//! \param triangles how many there are; the last block may have fewer than eight
void toSlots(const double *coordinates, double scale, int triangles, Lanes *slots, int first, int end);
void fromSlots(const Lanes *slots, double scale, int triangles, double *coordinates, int first, int end);

//! How the corners of eight triangles hang together with others.
struct CornerLinks
{
    LaneInts partner[6]; //!< per corner and side (2 k + side): the partner's slot, the own one at a border
    LaneInts pair[6];    //!< the corner pair; the number of pairs (an entry without weight) at a border
};

//! How the corners of eight triangles hang on hubs.
struct alignas(laneAlignment) HubLinks
{
    LaneInts hub[3];   //!< per corner, twice the number of its hub; for a corner on its own, of one at rest
    LaneInts place[3]; //!< twice the place of the corner in the list that is ordered by hubs
    LaneInts within;   //!< bit 2 k + side: the link is to a corner of the same hub
    LaneInts holding;  //!< bit 2 k + side: at least one end of the link is on its own
    Lanes star[3];     //!< spring constant between corner and hub
};

//! The triangles' part of a linear system: everything that one product needs.
struct alignas(laneAlignment) BlockSystem
{
    LaneMatrix inverse; //!< of the triangles, their springs to hubs and what holds them
    Lanes link[6];      //!< spring constants to the partners
};

//! q = H p for blocks first to end; returns p . q over them.
//! \param movable factors 0 or 1 per coordinate, null when nothing is held
double multiplyBlocks(const LaneMatrix *hessian, const BlockSystem *systems, const CornerLinks *links,
                      const Lanes *p, const Lanes *movable, Lanes *q, int first, int end);

//! x += alpha p, r -= alpha q; returns r . r.
double advanceBlocks(float alpha, const Lanes *p, const Lanes *q, Lanes *x, Lanes *r, int first, int end);

//! Loads of the corners on their hubs: star * y with y = inverse * r; returns r . y.
double loadHubs(const BlockSystem *systems, const HubLinks *hubs, const Lanes *r, float *loads, int first,
                int end);

//! p = z + beta p with z = inverse * (r + star * u), u the places of the hubs; p is not read when beta is 0.
void pullCorners(const BlockSystem *systems, const HubLinks *hubs, const Lanes *r, const float *u,
                 const Lanes *movable, float beta, Lanes *p, int first, int end);

//! Fills the systems of blocks first to end and adds the springs and `ground` to the diagonals of the
//! Hessians. \param pairs spring constant per corner pair, and a zero
//! \param ground,movable coordinates in the layout of p, or null
void prepareBlocks(const CornerLinks *links, const float *pairs, const Lanes *ground, const Lanes *movable,
                   LaneMatrix *hessian, BlockSystem *systems, HubLinks *hubs, int first, int end);

} // namespace autocuts
