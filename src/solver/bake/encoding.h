// Converts the values of baked maps to the numbers that picture files store.
#pragma once

#include "solver/bake/bakemaps.h"

#include <cstdint>

namespace autocuts::bake {

//! How the values of a map are converted for its file.
struct Encoding
{
    //! For files of floating point numbers: colours linear, positions, heights and curvatures as they are.
    //! Otherwise everything is in [0, 1], and colours are sRGB.
    bool floats = false;
    bool greenDown = false;          //!< tangent space normals for DirectX
    double heightRange = 1;          //!< height above the surface that becomes 1; as far below becomes 0
    Vec3 positionLow = Vec3::Zero(); //!< becomes 0
    double positionRange = 1;        //!< what is this far from it becomes 1
};

//! Directions become (direction + 1) / 2, heights and curvatures 1/2 where they are 0. Texels without a value
//! get the value of a flat, open surface.
void encode(Picture &picture, const MapRequest &request, TextureKind kind,
            const std::vector<std::uint8_t> &filled, const Encoding &encoding);

} // namespace autocuts::bake
