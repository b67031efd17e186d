// The steps of the grid and of the rulers in the UV view.
#pragma once

#include "model/plain/packingsettings.h"
#include "views/canvas/mapcamera.h"
#include "views/gl/backdrop.h"

namespace autocuts {

//! A grid in texels: lines are 1, 2, 4, ... texels or 1, 2, 5, 10, ... textures apart.
struct MapGrid
{
    double step = 1;      //!< distance between lines, in texture space
    double divisions = 2; //!< number of finer steps per step
    double strength = 0;  //!< opacity of the finer lines, 0 to 1

    //! Chooses the grid so that its lines are at least 48 pixels apart.
    static MapGrid of(const MapCamera &camera, int textureSize);
};

//! The numbers of columns and rows of UDIM tiles, from 1001, that a map covers; at least one each. A very
//! small excess is ignored. \param tileHeight of the texture, see PackingSettings::tileHeight()
Vec2 usedTiles(const Eigen::AlignedBox2d &uvBox, double tileHeight);

//! Positions of tiles and grid in the view. \param pixelRatio screen pixels per logical pixel
PaperDrawing paperDrawing(const MapCamera &camera, double pixelRatio, const PackingSettings &packing);

} // namespace autocuts
