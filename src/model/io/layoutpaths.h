// The outlines and lines that a picture of a UV layout consists of.
#pragma once

#include "model/plain/meshdata.h"

#include <utility>
#include <vector>

namespace autocuts {

//! Lines of a UV layout in UV units, cut off well outside the unit square.
struct LayoutPaths
{
    using Loop = std::vector<Vec2>;
    struct Line
    {
        std::vector<Vec2> points;
        bool closed = false; //!< the last point is joined to the first
    };

    //! Loops of each chart. They wind counter-clockwise around every triangle: filled by the non-zero rule
    //! they give all that the chart covers, however often it is flipped or covers itself.
    std::vector<std::vector<Loop>> islands;
    std::vector<Line> borders;                     //!< seams and boundaries
    std::vector<std::pair<Vec2, Vec2>> innerEdges; //!< polygon edges that are not borders
    std::vector<Loop> overlaps;                    //!< the triangles that were asked for
};

//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \param overlapping triangles of the mesh; those out of range or without UVs are left out
LayoutPaths layoutPaths(const MeshData &mesh, const UvMatrix &uv, const std::vector<int> &overlapping);

} // namespace autocuts
