// Packing of UV islands into a rectangle: the interface. Plain: no Qt.
#pragma once

#include "model/plain/packingsettings.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/packisland.h"

#include <vector>

namespace autocuts::packing {

//! The user's settings, and what else the packer needs. A texel is 1 / textureSize UV units. UDIM tile and
//! height of the texture are ignored, because the bin is given here; see tileOptions().
struct PackOptions : PackingSettings
{
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< the bin, UV units
    unsigned seed = 1;                               //!< of all random numbers
    int starts = 0; //!< number of independent searches that share the effort; 0: depends on the effort
    //! Where islands turn freely, those with borders along the axes stay so, see standsOnAxes(): for packing
    //! a map that is there.
    bool keepStraight = false;
};

//! Where an island goes: p' = scale * R(angle) * p + translation, in UV units. Never mirrored.
struct PackPlacement
{
    double angle = 0; //!< radians, counter-clockwise
    Vec2 translation = Vec2::Zero();
};

struct [[nodiscard]] PackResult
{
    double scale = 1; //!< of all islands that are not locked, relative to their size before
    std::vector<PackPlacement> placements; //!< one per island; not to be applied to locked ones
    double efficiency = 0;                 //!< sum of the islands' triangle areas / area of the bin
    //! False when there is no room at the given scale (keepScale), no room for the margins alone, or the job
    //! was stopped before the first layout. Then scale and placements leave every island where it was.
    bool complete = false;
};

//! Effort of packing, in seconds, for drafts and stopped jobs. On the first sets of islands (README.md) a
//! mean efficiency of .638, against .698 at 1 s.
inline constexpr double hurriedEffort = 0.1;

//! Packs islands at the largest common scale that it finds. Every complete result has passed an exact test of
//! distances, crossings and containment. The same arguments give the same bits. When the job is stopped, the
//! best layout so far is returned soon.
//! \pre indices of triangles and boundary are in range
//! \throws std::invalid_argument when the bin, the margin or the texture size is not a usable number
PackResult packIslands(const std::vector<PackIsland> &islands, const PackOptions &settings,
                       const JobContext &job = {});

} // namespace autocuts::packing
