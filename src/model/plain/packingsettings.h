// The user's settings for packing and for texel figures. Plain: no Qt.
#pragma once

#include <cmath>

namespace autocuts {

//! The rotations that the packer may apply to islands: none, any, or multiples of a step. Stored in sessions
//! by number.
enum class PackRotation { None, Quarter, Free, Half, Eighth, Twelfth, TwentyFourth };

//! How many directions an island may have; 0: any.
constexpr int directionsOf(PackRotation rotation)
{
    switch (rotation) {
    case PackRotation::None:
        return 1;
    case PackRotation::Half:
        return 2;
    case PackRotation::Quarter:
        return 4;
    case PackRotation::Eighth:
        return 8;
    case PackRotation::Twelfth:
        return 12;
    case PackRotation::TwentyFourth:
        return 24;
    case PackRotation::Free:
        break;
    }
    return 0;
}

//! How islands are packed into one tile of the texture.
struct PackingSettings
{
    static constexpr int maxTextureSize = 65536;
    static constexpr int firstTile = 1001; //!< UDIM: 1001 + column + 10 * row
    static constexpr int lastTile = 9999;

    int textureSize = 2048; //!< texels along the width of the texture
    double margin = 8;      //!< gutter: empty texels between islands
    int udimTile = firstTile;
    PackRotation rotation = PackRotation::Free;
    bool keepScale = false; //!< place the islands without changing their size
    //! Least distance to the border of the tile, texels; negative: half the margin.
    double border = -1;
    //! CPU seconds that the search may take, as counted work and not by a clock. Mean efficiency on four
    //! island sets at 4 texels of 1024: .657 at 0.5 s, .665 at 1 s, .678 at 10 s, .694 at 60 s.
    double effort = 0.5;
    static constexpr double maxEffort = 3600;
    int textureHeight = 0; //!< texels along the height of the texture; 0: as many as along the width

    //! Width and height of the texture in texels. \pre both are at least 1
    void setTexture(int width, int height)
    {
        textureSize = width;
        textureHeight = height == width ? 0 : height;
    }
    int height() const { return textureHeight > 0 ? textureHeight : textureSize; }
    //! Height of a tile of the texture. Texture space is proportional to texels: a tile is 1 wide and this
    //! high, and a texel is 1 / textureSize wide and high. In files a tile is 1 high, see
    //! model/io/formats/tilescaling.h.
    double tileHeight() const
    {
        return textureHeight > 0 ? static_cast<double>(textureHeight) / textureSize : 1;
    }
    int shorterSide() const { return textureSize < height() ? textureSize : height(); }

    //! True when a session may store these settings: all values are in range, and the gutter is a whole
    //! number of texels.
    bool isValid() const
    {
        return textureSize >= 1 && textureSize <= maxTextureSize && textureHeight >= 0 &&
               textureHeight <= maxTextureSize && margin >= 0 && margin <= shorterSide() &&
               margin == std::floor(margin) && udimTile >= firstTile && udimTile <= lastTile &&
               rotation >= PackRotation::None && rotation <= PackRotation::TwentyFourth &&
               border < 0.5 * shorterSide() && !std::isnan(border) && effort >= 0 && effort <= maxEffort;
    }

    bool operator==(const PackingSettings &) const = default;
};

} // namespace autocuts
