// Overlays of both views: legend, axes, messages.
#pragma once

#include "views/gl/viewcolors.h"
#include "views/state/viewstate.h"

#include <QRect>
#include <QStringList>

class QPainter;

namespace autocuts {

class ToolCanvas;

//! Draws a title and lines at the centre of an empty view.
void drawMessage(QPainter &painter, const QRect &view, const ViewColors &colors, const QString &title,
                 const QStringList &lines);
//! Draws a word in the upper left corner: a way of working that one has to know of.
void drawBadge(QPainter &painter, const QRect &view, const ViewColors &colors, const QString &text);
//! Draws the legend of the face colours; nothing when the colours show no number.
//! \param rightDensity as SceneContent::rightDensity()
//! \returns its place; null when there is none
QRectF drawLegend(QPainter &painter, const QRect &view, const ViewColors &colors, const ViewOptions &options,
                  bool colorBlind, double rightDensity);
//! Draws the legend of the edges that are kept straight, in the lower left corner.
//! \param legend place of the other one, which stays free
void drawStraightLegend(QPainter &painter, const QRect &view, const ViewColors &colors, const QRectF &legend);
//! Draws a ring around the vertex under the mouse, in the mode for selecting vertices.
void drawHoverCorner(QPainter &painter, const ToolCanvas &canvas);

} // namespace autocuts
