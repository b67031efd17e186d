// What the user can choose about packing, and what texel figures refer to. Plain: no Qt.
#pragma once

namespace autocuts {

//! How islands are packed into a tile of the texture.
struct PackingSettings
{
    enum class Rotation { None, Quarter, Free };

    static constexpr int maxTextureSize = 65536;
    static constexpr int firstTile = 1001; //!< UDIM: 1001 + column + 10 * row
    static constexpr int lastTile = 9999;

    int textureSize = 2048; //!< texels along one side
    int margin = 8;         //!< gutter between islands, in texels
    int udimTile = firstTile;
    Rotation rotation = Rotation::Free;
    bool keepScale = false; //!< place the islands at the size they have

    bool isValid() const
    {
        return textureSize >= 1 && textureSize <= maxTextureSize && margin >= 0 && margin <= textureSize &&
               udimTile >= firstTile && udimTile <= lastTile && rotation >= Rotation::None &&
               rotation <= Rotation::Free;
    }

    bool operator==(const PackingSettings &) const = default;
};

} // namespace autocuts
