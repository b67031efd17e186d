// Where a point of a view is in the map.
#pragma once

#include "model/plain/types.h"
#include "views/canvas/picking.h"

#include <QPointF>

#include <optional>

namespace autocuts {

class ToolCanvas;

//! A place of the map, and how the view shows the map around it.
struct MapSpot
{
    int triangle = -1;
    Vec2 uv = Vec2::Zero();
    Eigen::Matrix2d toUv; //!< from logical pixels, y pointing down, to texture space

    double unitsPerPixel() const;
};

//! The place under a pixel: in the 3D view, by the triangle there. Nothing where there is no map.
std::optional<MapSpot> mapSpotAt(const ToolCanvas &canvas, const QPointF &pixel, const PickResult &pick);

//! The same for a round brush whose centre may be beside the map: the triangle is then another one under it.
//! \param radius logical pixels
std::optional<MapSpot> mapSpotUnder(const ToolCanvas &canvas, const QPointF &centre, const PickResult &pick,
                                    double radius);

} // namespace autocuts
