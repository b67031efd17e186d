// Rectangles of the map under the mouse, and the faces assigned to them.
#pragma once

#include "commands/editrectangles.h"
#include "views/canvas/mapcamera.h"

#include <QList>
#include <QRectF>

namespace autocuts {

//! What of a rectangle a drag takes hold of.
struct RectangleGrip
{
    int id = 0;       //!< 0: of none
    int x = 0, y = 0; //!< sides that move: -1 the lower one, 1 the upper one, 0 neither; both 0: all of it

    bool isHandle() const { return x != 0 || y != 0; }
};

//! Where a rectangle is drawn.
QRectF screenBox(const LayoutRectangle &rectangle, const MapCamera &camera);
//! Middle of a handle of a rectangle. \param x, y as in RectangleGrip
QPointF handleOf(const QRectF &box, int x, int y);
//! A handle of the active rectangle, or else the outline or the name of any.
RectangleGrip gripAt(const std::vector<LayoutRectangle> &rectangles, int active, const MapCamera &camera,
                     const QPointF &pixel);
//! The smallest rectangle around a place; 0 when there is none.
int rectangleAround(const std::vector<LayoutRectangle> &rectangles, const Vec2 &uv);
//! The rectangle after its grip was moved. Its corners may be the wrong way round.
LayoutRectangle dragged(LayoutRectangle rectangle, const RectangleGrip &grip, const Vec2 &by,
                        double snapStep);

//! Assigns faces to a rectangle and takes them out of all others. \param id 0: only takes them out
std::unique_ptr<EditRectangles> assignFaces(Document &document, int id, const QList<int> &faces);

} // namespace autocuts
