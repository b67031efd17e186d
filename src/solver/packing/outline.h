// The outline of an island: its edges, centred and in the packer's units.
#pragma once

#include "solver/packing/packisland.h"

#include <optional>
#include <vector>

namespace autocuts::packing {

//! Sum of the absolute areas of an island's triangles, UV units squared. Triangles with a point that is not
//! usable are left out.
double islandArea(const PackIsland &island);

//! True when the packer can use this point: finite, and so small that squares and sums of it are finite too.
bool isUsablePoint(const Vec2 &point);

//! The edges between inside and outside of an island. A point is inside when its winding number is not zero,
//! with every triangle counted as counter-clockwise. So folded and self-overlapping islands cover the same
//! area as their triangles do.
struct Outline
{
    struct Edge
    {
        int a, b;    //!< indices into points
        int winding; //!< winding number left of a -> b less that on the right; 0: boundary edge only
    };

    std::vector<Vec2> points;         //!< ends of the edges; (UV - centre) / unit
    std::vector<Edge> edges;          //!< may have zero length; not empty unless points is
    std::vector<int> componentPoints; //!< one point of each connected set of edges
    std::vector<Vec2> hull;           //!< convex hull, counter-clockwise; one or two points when degenerate
    Vec2 centre = Vec2::Zero();       //!< UV units
    double area = 0;                  //!< of the triangles, units squared
    double perimeter = 0;             //!< length of all edges, units
    double radius = 0;                //!< largest distance of a point from the centre, units
    double boxAngle = 0;              //!< radians: turned by it, the box of least area is axis-parallel
    //! Radians: turned by it, the border runs along the axes. Nothing when the border does not run mostly in
    //! two directions at a right angle, as that of an unfolded box does.
    std::optional<double> squareAngle;

    //! Winding number at p, in the coordinates of points; undefined on an edge.
    int windingAt(const Vec2 &p) const;

    // Edges by horizontal strip, so that windingAt() tests few of them.
    double stripLower = 0, stripHeight = 0;
    std::vector<int> stripStart, stripEdges;
};

//! Makes the outline of an island.
//! \param unit UV units per unit of the outline. \pre unit > 0
Outline makeOutline(const PackIsland &island, double unit);

//! True when a good part of the border runs along the axes as the island stands. In any other place hardly a
//! side does.
bool standsOnAxes(const Outline &outline);

//! Size of the axis-parallel box around the hull after a turn by `angle` (radians).
Vec2 rotatedBox(const std::vector<Vec2> &hull, double angle);

} // namespace autocuts::packing
