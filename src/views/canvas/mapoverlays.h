// What is painted over the map: tiles, rulers, rectangles.
#pragma once

#include "model/document/constraints.h"
#include "views/canvas/mapcamera.h"
#include "views/gl/viewcolors.h"

#include <QRect>

#include <vector>

class QPainter;

namespace autocuts {

//! UDIM numbers of the tiles in the view, where there is room for them.
void drawTileNames(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera);
//! Rulers along the upper and the left side, in texels from the corner of the first tile.
void drawRulers(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera,
                int textureSize);
//! Outlines with names; hard ones with a thick line, soft ones dashed.
void drawRectangles(QPainter &painter, const std::vector<LayoutRectangle> &rectangles,
                    const MapCamera &camera);

} // namespace autocuts
