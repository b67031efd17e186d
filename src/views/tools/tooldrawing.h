// What several tools paint over the views.
#pragma once

#include <QColor>
#include <QString>

#include <span>

class QPainter;

namespace autocuts {

class ToolCanvas;

//! Edges as lines; fainter where only faces turned away from the viewer have them.
//! \param edges of MeshAdjacency
void drawEdges(QPainter &painter, const ToolCanvas &canvas, std::span<const int> edges, const QColor &color);
//! A line of text in the upper middle.
void drawNote(QPainter &painter, const ToolCanvas &canvas, const QString &text);

} // namespace autocuts
