// What is painted over both views: legend, axes, messages.
#pragma once

#include "views/gl/viewcolors.h"
#include "views/state/viewstate.h"

#include <QRect>
#include <QStringList>

class QPainter;

namespace autocuts {

class ToolCanvas;
class OrbitCamera;

//! A title and lines in the middle of an empty view.
void drawMessage(QPainter &painter, const QRect &view, const ViewColors &colors, const QString &title,
                 const QStringList &lines);
//! What the colours of the faces stand for; nothing where they stand for no number.
void drawLegend(QPainter &painter, const QRect &view, const ViewColors &colors, const ViewOptions &options,
                bool colorBlind);
//! The axes as the camera sees them, in the upper right.
void drawGizmo(QPainter &painter, const QRect &view, const ViewColors &colors, const OrbitCamera &camera);
//! A ring around the vertex that the mouse is over, while vertices are selected.
void drawHoverCorner(QPainter &painter, const ToolCanvas &canvas);

} // namespace autocuts
