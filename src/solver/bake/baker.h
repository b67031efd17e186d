// Bakes maps: for each texel of a model's UV map, what is found at its point of the surface.
#pragma once

#include "solver/bake/bakemaps.h"
#include "solver/bake/texels.h"
#include "solver/base/jobcontext.h"

#include <cstdint>

namespace autocuts::bake {

//! The settings of a bake of one tile.
struct BakeSettings
{
    std::vector<MapRequest> maps;
    TexelGrid grid; //!< its perSide^2 samples per texel each look for a point of the detailed model
    CageSettings cage;
    RaySettings rays;
};

//! The finished maps of a tile, and counts of its texels.
struct BakeResult
{
    bool stopped = false; //!< then rows are missing
    //! As BakeSettings::maps. Directions are in [-1, 1], colours linear, the rest as MapKind says. Texels
    //! without a value are 0.
    std::vector<Picture> maps;
    std::vector<std::uint8_t> filled; //!< per texel: it has a value
    long long texels = 0;             //!< inside of islands
    long long missed = 0;             //!< of them: none of their rays met the detailed model
    long long overlapped = 0;         //!< of them: with more than one triangle
};

//! Bakes one tile. Results do not depend on the number of threads.
//! \pre low.uv has a row per corner; low.tangents are there for maps in tangent space
BakeResult bakeTile(const ShadedSurface &low, const Projection &projection, const Frame &frame,
                    const BakeSettings &settings, const JobContext &job);

} // namespace autocuts::bake
