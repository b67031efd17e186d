// Packing of UV islands into a rectangle: the interface. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <array>
#include <atomic>
#include <functional>
#include <vector>

namespace autocuts::packing {

//! One rigid piece of the UV map.
struct PackIsland
{
    std::vector<Vec2> points;                  //!< UV units; points that are not finite are ignored
    std::vector<std::array<int, 3>> triangles; //!< indices into points, any winding
    std::vector<std::array<int, 2>> boundary;  //!< open edges, indices into points
    bool locked = false;                       //!< keeps its place and size and is an obstacle
};

//! Which turns the packer may make.
enum class PackRotation { Free, Quarter, None };

//! What the user can choose about packing. A texel is 1 / textureSize UV units.
struct PackSettings
{
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< the bin, UV units
    int textureSize = 2048;
    double margin = 8;  //!< texels, true distance between two islands
    double border = -1; //!< texels to the border of the bin; negative: half the margin
    PackRotation rotation = PackRotation::Free;
    bool keepScale = false;
    double effort = 0.5; //!< CPU seconds asked for; turned into counted work, never into clock readings
    unsigned seed = 1;
    int starts = 0;  //!< independent searches that share the effort; 0: chosen by the effort
    int threads = 1; //!< over the starts; does not change the result
};

//! Where an island goes: p' = scale * R(angle) * p + translation. Never mirrored.
struct PackPlacement
{
    double angle = 0; //!< radians, counter-clockwise
    Vec2 translation = Vec2::Zero();
};

struct PackResult
{
    double scale = 1;                      //!< common to all islands that are not locked
    std::vector<PackPlacement> placements; //!< one per island; locked ones must be left alone
    double efficiency = 0;                 //!< sum of the islands' triangle areas / area of the bin
    bool complete = false; //!< false: no room at this scale (keepScale), no room for the margins alone, or
                           //!< cancelled before the first layout. The placements then leave all as it was.
};

//! Packs islands at one common scale, as large as it can find. Every layout that is returned as complete has
//! passed an exact test of distances, crossings and containment. The same arguments give the same bits.
//! \param cancel when it becomes true, the best layout so far is returned soon
//! \param progress called from the calling thread with the part of the work that is done, in [0, 1]
//! \pre indices of triangles and boundary are in range
//! \throws std::invalid_argument when the bin, the margin or the texture size is not a usable number
PackResult packIslands(const std::vector<PackIsland> &islands, const PackSettings &settings,
                       const std::atomic<bool> *cancel = nullptr,
                       const std::function<void(double)> &progress = {});

} // namespace autocuts::packing
