// The shape of an island as the packer sees it: its edges, centred and in the packer's units.
#pragma once

#include "solver/packing/packisland.h"

namespace autocuts::packing {

//! Sum of the absolute areas of an island's triangles; those with a point that is not usable count nothing.
double islandArea(const PackIsland &island);

//! True when the packer can use this point: finite, and small enough that its square is.
bool isUsablePoint(const Vec2 &point);

//! What covers the plane is the set of points with a winding number other than zero, where every triangle is
//! first turned counter-clockwise: folded and self-overlapping islands are covered as one would see them.
struct Outline
{
    struct Edge
    {
        int a, b;    //!< into points
        int winding; //!< how much larger the winding number is on the left of a -> b; 0: only an open edge
    };

    std::vector<Vec2> points;         //!< those of the edges; (UV - centre) / unit
    std::vector<Edge> edges;          //!< may have zero length; never empty when points is not
    std::vector<int> componentPoints; //!< one point of each connected set of edges
    std::vector<Vec2> hull;           //!< convex hull, counter-clockwise; one or two points when degenerate
    Vec2 centre = Vec2::Zero();       //!< UV units
    double area = 0;                  //!< of the triangles, units squared
    double perimeter = 0;             //!< length of all edges
    double radius = 0;                //!< largest distance of a point from the centre
    double boxAngle = 0;              //!< the turn that makes the box of least area upright

    //! Winding number at p (same coordinates as points); undefined on an edge itself.
    int windingAt(const Vec2 &p) const;

    // Edges by horizontal strip, so that windingAt() looks at few of them.
    double stripLower = 0, stripHeight = 0;
    std::vector<int> stripStart, stripEdges;
};

//! \param unit UV units per unit of the outline. \pre unit > 0
Outline makeOutline(const PackIsland &island, double unit);

//! Size of the axis-parallel box around the hull after a turn by angle.
Vec2 rotatedBox(const std::vector<Vec2> &hull, double angle);

} // namespace autocuts::packing
