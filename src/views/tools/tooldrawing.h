// Drawing functions shared by tools.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

#include <span>

class QPainter;

namespace autocuts {

class ToolCanvas;
struct Brush;

//! Draws edges as lines, fainter where all of their faces are turned away from the viewer.
//! \param edges edges of MeshAdjacency
void drawEdges(QPainter &painter, const ToolCanvas &canvas, std::span<const int> edges, const QColor &color);
//! Draws a brush as a circle, with a dotted one where its full strength ends. \param opacity of its inside
void drawBrush(QPainter &painter, const ToolCanvas &canvas, const QPointF &centre, const Brush &brush,
               const QColor &color, double opacity);
//! Draws a line of text at the top centre.
void drawNote(QPainter &painter, const ToolCanvas &canvas, const QString &text);

} // namespace autocuts
