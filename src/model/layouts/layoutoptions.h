// Options for pictures of UV layouts.
#pragma once

#include <QColor>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace autocuts {

enum class LayoutBackground { Transparent, Dark, Light };

//! How a layout is drawn. The picture shows the first tile of the texture with v pointing up; anything
//! outside is cut off.
struct LayoutOptions
{
    int size = 2048;   //!< pixels along the longer side, 16 to 16384
    bool edges = true; //!< draw the edges inside the islands
    bool fill = true;  //!< fill the islands
    bool seams = true; //!< draw the outlines of the islands
    //! Pixels by which the fill of each island extends beyond its outline, 0 to 256, so that textures painted
    //! over the picture have no empty border. Never covers another island.
    int bleed = 0;
    LayoutBackground background = LayoutBackground::Dark;
    //! Without a value, chosen to suit the background.
    std::optional<QColor> islandColor, edgeColor, seamColor;
    std::vector<int> overlapping; //!< triangles of the mesh to hatch
    double tileHeight = 1;        //!< of the texture, see PackingSettings::tileHeight()

    int width() const
    {
        return tileHeight > 1 ? std::max(1, static_cast<int>(std::lround(size / tileHeight))) : size;
    }
    int height() const
    {
        return tileHeight < 1 ? std::max(1, static_cast<int>(std::lround(size * tileHeight))) : size;
    }
};

} // namespace autocuts
