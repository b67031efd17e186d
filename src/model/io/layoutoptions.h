// How pictures of UV layouts are drawn.
#pragma once

#include <QColor>

#include <optional>
#include <vector>

namespace autocuts {

enum class LayoutBackground { Transparent, Dark, Light };

//! How a layout is drawn. The unit square fills the picture, v up; what lies outside is not shown.
struct LayoutOptions
{
    int size = 2048;   //!< texture size: pixels along each side, 16 to 16384
    bool edges = true; //!< draw the edges inside the islands
    bool fill = true;  //!< fill the islands
    bool seams = true; //!< draw the outlines of the islands
    //! Pixels by which the fill of each island goes on beyond its outline, 0 to 256: for painting without a
    //! bare rim. Never covers another island.
    int bleed = 0;
    LayoutBackground background = LayoutBackground::Dark;
    std::optional<QColor> islandColor, edgeColor, seamColor; //!< none: chosen by the background
    std::vector<int> overlapping;                            //!< triangles of the mesh to hatch
};

} // namespace autocuts
