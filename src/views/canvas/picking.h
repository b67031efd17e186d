// The results of picking.
#pragma once

#include "views/state/viewstate.h"

#include <QPointF>
#include <QRectF>

#include <functional>
#include <utility>
#include <vector>

namespace autocuts {

//! Logical pixels: largest distance of the mouse from an edge or a vertex. Chosen by hand.
inline constexpr double pickRadius = 8;

//! The elements at or near a point of a view; -1 for none.
struct PickResult
{
    int triangle = -1;   //!< the front-most triangle at the point
    int side = -1;       //!< 3 * triangle + k: the nearest polygon side within pickRadius
    int edge = -1;       //!< the edge of MeshAdjacency on which the side lies
    int soupCorner = -1; //!< the nearest soup corner within pickRadius
    int corner = -1;     //!< its polygon corner

    Hover hover() const { return {triangle, edge, corner}; }
};

//! A region of a view, in logical pixels.
struct PickRegion
{
    QRectF box;
    std::function<bool(const QPointF &)> inside; //!< called for points in the box; null: the whole box

    PickRegion(const QRectF &whole) : box(whole) {} // implicit: a rectangle can be used as a region
    PickRegion(const QRectF &around, std::function<bool(const QPointF &)> contains)
        : box(around), inside(std::move(contains))
    {}
    bool contains(const QPointF &point) const { return box.contains(point) && (!inside || inside(point)); }
};

//! The elements in a region of a view, as strictly ascending lists: faces by their centres, edges by their
//! midpoints. Elements hidden behind other faces are not included.
struct BoxPick
{
    std::vector<int> faces, edges, corners;
};

//! The point on a segment nearest to a given point, in pixels.
struct SegmentPlace
{
    double distance = 0;
    double along = 0; //!< 0 at the first end, 1 at the second
};
SegmentPlace nearestOnSegment(double px, double py, double ax, double ay, double bx, double by);

} // namespace autocuts
