// Finds rectangles under the mouse and assigns faces to them.
#pragma once

#include "commands/editrectangles.h"
#include "views/canvas/mapcamera.h"

#include <QList>
#include <QRectF>

namespace autocuts {

//! The part of a rectangle that a drag moves.
struct RectangleGrip
{
    int id = 0;       //!< 0: no rectangle
    int x = 0, y = 0; //!< the moving sides: -1 the lower, 1 the upper, 0 none; both 0: the whole rectangle

    bool isHandle() const { return x != 0 || y != 0; }
};

//! The screen position of a rectangle.
QRectF screenBox(const LayoutRectangle &rectangle, const MapCamera &camera);
//! Centre of a handle of a rectangle. \param x, y as in RectangleGrip
QPointF handleOf(const QRectF &box, int x, int y);
//! The grip at a position: a handle of the active rectangle, or the outline or name of any rectangle.
RectangleGrip gripAt(const std::vector<LayoutRectangle> &rectangles, int active, const MapCamera &camera,
                     const QPointF &pixel);
//! The smallest rectangle that contains a position; 0 when there is none.
int rectangleAround(const std::vector<LayoutRectangle> &rectangles, const Vec2 &uv);
//! The rectangle after its grip was moved. Its corners may be swapped.
LayoutRectangle dragged(LayoutRectangle rectangle, const RectangleGrip &grip, const Vec2 &by,
                        const Vec2 &snapStep);

//! Assigns faces to a rectangle and removes them from all others. \param id 0: only removes them
std::unique_ptr<EditRectangles> assignFaces(Document &document, int id, const QList<int> &faces);

} // namespace autocuts
