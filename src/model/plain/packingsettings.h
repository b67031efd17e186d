// What the user can choose about packing, and what texel figures refer to. Plain: no Qt.
#pragma once

#include <cmath>

namespace autocuts {

//! Which turns packing may make. Stored in sessions by number.
enum class PackRotation { None, Quarter, Free };

//! How islands are packed into a tile of the texture.
struct PackingSettings
{
    static constexpr int maxTextureSize = 65536;
    static constexpr int firstTile = 1001; //!< UDIM: 1001 + column + 10 * row
    static constexpr int lastTile = 9999;

    int textureSize = 2048; //!< texels along one side
    double margin = 8;      //!< gutter between islands, in texels
    int udimTile = firstTile;
    PackRotation rotation = PackRotation::Free;
    bool keepScale = false; //!< place the islands at the size they have

    //! Whether a session may hold them: its margins are whole texels.
    bool isValid() const
    {
        return textureSize >= 1 && textureSize <= maxTextureSize && margin >= 0 && margin <= textureSize &&
               margin == std::floor(margin) && udimTile >= firstTile && udimTile <= lastTile &&
               rotation >= PackRotation::None && rotation <= PackRotation::Free;
    }

    bool operator==(const PackingSettings &) const = default;
};

} // namespace autocuts
