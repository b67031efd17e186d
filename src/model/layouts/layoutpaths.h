// The outlines and lines of a picture of a UV layout.
#pragma once

#include "model/plain/meshdata.h"

#include <utility>
#include <vector>

namespace autocuts {

//! The lines of a UV layout in UV units, clipped to a region larger than the first tile of the texture.
struct LayoutPaths
{
    using Loop = std::vector<Vec2>;
    struct Line
    {
        std::vector<Vec2> points;
        bool closed = false; //!< the last point is connected to the first
    };

    //! The loops of each island. They wind counter-clockwise around every triangle, so that the non-zero fill
    //! rule covers the whole island, also where it is flipped or overlaps itself.
    std::vector<std::vector<Loop>> islands;
    //! Per island: its outline would cross itself all over, so that its loops are its triangles.
    std::vector<bool> isTangle;
    std::vector<Line> borders;                     //!< seams and mesh boundaries
    std::vector<std::pair<Vec2, Vec2>> innerEdges; //!< polygon edges that are not borders
    std::vector<Loop> overlaps;                    //!< the triangles given as `overlapping`
};

//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \param tileHeight of the texture, see PackingSettings::tileHeight()
//! \param overlapping triangles of the mesh; those out of range or without UVs are ignored
LayoutPaths layoutPaths(const MeshData &mesh, const UvMatrix &uv, double tileHeight,
                        const std::vector<int> &overlapping);

} // namespace autocuts
