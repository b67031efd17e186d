// Overlays of the UV view: tiles, rulers, rectangles.
#pragma once

#include "model/document/constraints.h"
#include "views/canvas/mapcamera.h"
#include "views/gl/viewcolors.h"

#include <QColor>
#include <QRect>

#include <utility>
#include <vector>

class QPainter;

namespace autocuts {

class Document;

//! Of the rulers, in logical pixels.
inline constexpr int rulerSize = 18;

//! Draws the UDIM numbers of the visible tiles that are large enough, where the view does not cut them.
void drawTileNames(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera,
                   double tileHeight);
//! Draws the sides of the visible tiles in use where they are large enough on the screen, and tints them.
//! \param tiles their numbers, with their colours
void drawTilesInUse(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera,
                    double tileHeight, const std::vector<std::pair<int, QColor>> &tiles);
//! Draws rulers at the upper and left side, in texels from the corner of tile 1001. Numbers that the view
//! would cut are left out.
void drawRulers(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera,
                int textureSize);
//! Draws outlines and names of rectangles; hard ones with a thick line, soft ones dashed.
void drawRectangles(QPainter &painter, const std::vector<LayoutRectangle> &rectangles,
                    const MapCamera &camera);

//! Draws the numbers of the islands and whether they are locked, upright, grouped or stacked, in the middle
//! of those that are large enough on the screen.
void drawIslandMarks(QPainter &painter, const QRect &view, const ViewColors &colors, const Document &document,
                     const MapCamera &camera, bool marks, bool numbers);
//! Frames the islands that do not lie in their tile as a whole, and names them and the tile.
//! \param islands see UvMetrics::chartsOffTile
void drawOffTile(QPainter &painter, const ViewColors &colors, const Document &document,
                 const MapCamera &camera, const std::vector<std::pair<int, int>> &islands);
//! Draws the 2D cursor, a ring with a cross.
void drawCursor(QPainter &painter, const ViewColors &colors, const QPointF &place);

} // namespace autocuts
