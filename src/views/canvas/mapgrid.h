// Steps of the grid and the rulers of the UV view.
#pragma once

#include "views/canvas/mapcamera.h"
#include "views/gl/backdrop.h"

namespace autocuts {

//! A grid in texels: every line is 1, 2, 4, ... texels or 1, 2, 5, 10, ... textures from the next.
struct MapGrid
{
    double step = 1;      //!< between lines, texture space
    double divisions = 2; //!< finer lines per step
    double strength = 0;  //!< 0 to 1: how strongly the finer ones are drawn

    //! Lines are at least 48 pixels apart.
    static MapGrid of(const MapCamera &camera, int textureSize);
};

//! Columns and rows of tiles, from 1001, that a map reaches into; at least one of each. What stands over by a
//! little does not count.
Vec2 usedTiles(const Eigen::AlignedBox2d &uvBox);

//! Where tiles and grid lie in the view. \param pixelRatio pixels of the screen per logical pixel
PaperDrawing paperDrawing(const MapCamera &camera, double pixelRatio, int textureSize);

} // namespace autocuts
