// The handles for moving, rotating and scaling islands.
#pragma once

#include "commands/setuvs.h"
#include "views/gl/viewcolors.h"
#include "views/tools/islanddrag.h"

#include <QPointF>

#include <optional>

class QPainter;

namespace autocuts {

//! Length of the arrows and radius of the ring, in logical pixels.
inline constexpr double gizmoLength = 64;

//! The handle under the mouse, given by its axis; nothing when there is none.
//! \param edit Move, Rotate or Scale \param centre of the gizmo, in pixels
std::optional<DragAxis> gizmoPartAt(UvEdit edit, const QPointF &centre, const QPointF &mouse);
//! \param marked the handle to draw as held
void drawIslandGizmo(QPainter &painter, UvEdit edit, const QPointF &centre, std::optional<DragAxis> marked,
                     const ViewColors &colors);

} // namespace autocuts
