// The user's settings for packing and for texel figures. Plain: no Qt.
#pragma once

#include <cmath>

namespace autocuts {

//! The rotations that the packer may apply to islands. Stored in sessions by number.
enum class PackRotation { None, Quarter, Free };

//! How islands are packed into one tile of the texture.
struct PackingSettings
{
    static constexpr int maxTextureSize = 65536;
    static constexpr int firstTile = 1001; //!< UDIM: 1001 + column + 10 * row
    static constexpr int lastTile = 9999;

    int textureSize = 2048; //!< texels along one side of the texture
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

    //! True when a session may store these settings: all values are in range, and the gutter is a whole
    //! number of texels.
    bool isValid() const
    {
        return textureSize >= 1 && textureSize <= maxTextureSize && margin >= 0 && margin <= textureSize &&
               margin == std::floor(margin) && udimTile >= firstTile && udimTile <= lastTile &&
               rotation >= PackRotation::None && rotation <= PackRotation::Free &&
               border < 0.5 * textureSize && !std::isnan(border) && effort >= 0 && effort <= maxEffort;
    }

    bool operator==(const PackingSettings &) const = default;
};

} // namespace autocuts
