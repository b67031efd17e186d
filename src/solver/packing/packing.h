// Packing of UV islands into a rectangle: the interface. Plain: no Qt.
#pragma once

#include "model/plain/packingsettings.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/packisland.h"

#include <atomic>
#include <functional>
#include <vector>

namespace autocuts::packing {

//! What the user sets, and what the packer needs beyond that. A texel is 1 / textureSize UV units. The tile
//! is not looked at: the bin is given, see tileOptions().
struct PackOptions : PackingSettings
{
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< the bin, UV units
    double border = -1;  //!< texels to the border of the bin; negative: half the margin
    double effort = 0.5; //!< CPU seconds asked for; turned into counted work, never into clock readings
    unsigned seed = 1;
    int starts = 0; //!< independent searches that share the effort; 0: chosen by the effort
};

//! Where an island goes: p' = scale * R(angle) * p + translation. Never mirrored.
struct PackPlacement
{
    double angle = 0; //!< radians, counter-clockwise
    Vec2 translation = Vec2::Zero();
};

struct [[nodiscard]] PackResult
{
    double scale = 1;                      //!< common to all islands that are not locked
    std::vector<PackPlacement> placements; //!< one per island; locked ones must be left alone
    double efficiency = 0;                 //!< sum of the islands' triangle areas / area of the bin
    bool complete = false; //!< false: no room at this scale (keepScale), no room for the margins alone, or
                           //!< cancelled before the first layout. The placements then leave all as it was.
};

//! Effort of packing, in seconds, when there is no time: enough for a usable layout of hundreds of islands.
inline constexpr double hurriedEffort = 0.1;

//! Packs islands at one common scale, as large as it can find. Every layout that is returned as complete has
//! passed an exact test of distances, crossings and containment. The same arguments give the same bits.
//! When the job is stopped, the best layout so far is returned soon.
//! \pre indices of triangles and boundary are in range
//! \throws std::invalid_argument when the bin, the margin or the texture size is not a usable number
PackResult packIslands(const std::vector<PackIsland> &islands, const PackOptions &settings,
                       const JobContext &job = {});

} // namespace autocuts::packing
