// What picking finds.
#pragma once

#include "views/state/viewstate.h"

#include <QPointF>
#include <QRectF>

#include <functional>
#include <utility>
#include <vector>

namespace autocuts {

//! How near the mouse must be to an edge or a vertex, logical pixels.
inline constexpr double pickRadius = 8;

//! What is under, or near, a point of a view. -1 for none.
struct PickResult
{
    int triangle = -1;   //!< front-most under the point
    int side = -1;       //!< 3 * triangle + k: the nearest side of a polygon within pickRadius
    int edge = -1;       //!< of MeshAdjacency, that the side lies on
    int soupCorner = -1; //!< the nearest within pickRadius
    int corner = -1;     //!< polygon corner of it

    Hover hover() const { return {triangle, edge, corner}; }
};

//! A part of a view, in logical pixels.
struct PickRegion
{
    QRectF box;
    std::function<bool(const QPointF &)> inside; //!< asked for points of the box; null: all of it

    PickRegion(const QRectF &whole) : box(whole) {} // a rectangle is a region as it is
    PickRegion(const QRectF &around, std::function<bool(const QPointF &)> contains)
        : box(around), inside(std::move(contains))
    {}
    bool contains(const QPointF &point) const { return box.contains(point) && (!inside || inside(point)); }
};

//! What lies in a region of a view, each list strictly rising: faces by their centres, edges by their
//! middles. What is hidden behind other faces is not among it.
struct BoxPick
{
    std::vector<int> faces, edges, corners;
};

//! The place on a segment nearest to a point, in pixels.
struct SegmentPlace
{
    double distance = 0;
    double along = 0; //!< 0 at the first end, 1 at the second
};
SegmentPlace nearestOnSegment(double px, double py, double ax, double ay, double bx, double by);

} // namespace autocuts
