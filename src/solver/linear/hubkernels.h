// The vector loops of the conjugate gradients with hubs: eight triangles at a time.
#pragma once

#include "solver/linear/lanes.h"

#include <array>

namespace autocuts {

using LaneInts = std::array<int, laneCount>;

//! How the corners of eight triangles hang together with others. Coordinates lie in a flat vector of floats,
//! six Lanes per block; a *slot* is the place of a corner's u in it, its v is laneCount further.
struct CornerLinks
{
    LaneInts partner[6]; //!< per corner and side (2 k + side): the partner's slot, the own one at a border
    LaneInts pair[6];    //!< the corner pair; the number of pairs (an entry without weight) at a border
};

//! How the corners of eight triangles hang on hubs.
struct alignas(laneAlignment) HubLinks
{
    LaneInts hub[3];   //!< per corner; the number of hubs (an entry at rest) for a corner on its own
    LaneInts place[3]; //!< of the corner's load in the list that is ordered by hubs
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

//! p = z + beta p with z = inverse * (r + star * u), u the places of the hubs.
void pullCorners(const BlockSystem *systems, const HubLinks *hubs, const Lanes *r, const float *u,
                 const Lanes *movable, float beta, Lanes *p, int first, int end);

//! Fills the systems of blocks first to end and adds the springs and `ground` to the diagonals of the
//! Hessians. \param pairs spring constant per corner pair, and a zero \param hubOfSlot hub at the slot of
//! each corner, hubCount for none \param ground,movable coordinates in the layout of p, or null
void prepareBlocks(const CornerLinks *links, const float *pairs, const int *hubOfSlot, int hubCount,
                   const Lanes *ground, const Lanes *movable, LaneMatrix *hessian, BlockSystem *systems,
                   HubLinks *hubs, int first, int end);

} // namespace autocuts
