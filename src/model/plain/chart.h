// Charts (UV islands): components of faces that are joined in UV space. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! The chart of every face. A face without UVs has chart -1.
struct ChartMap
{
    std::vector<int> faceChart;
    int count = 0;

    //! The faces of each chart, in rising order.
    std::vector<std::vector<int>> faces() const;
};

//! Polygon sides on one welded 3D edge whose UVs agree at both ends: one edge of the UV map.
struct UvEdge
{
    std::array<int, 2> corner; //!< corners at its ends, of one of its sides; the lower welded vertex first
    int chart = 0;
    bool open = false; //!< one side only: a border of its chart
};

//! A welded 3D edge and how its sides are joined in UV space.
struct WeldedEdge
{
    std::array<int, 2> corner; //!< corners at its ends, the lower welded vertex first
    int sides = 0;             //!< polygon sides on it
    int sidesWithUv = 0;       //!< of these, sides of faces with UVs
    int copies = 0;            //!< edges that it has in the UV map
};

//! How a UV map hangs together, by the rule of findCharts().
struct UvTopology
{
    ChartMap charts;
    std::vector<bool> faceHasUv; //!< all corners finite
    std::vector<int> cornerRoot; //!< first corner of the UV vertex that each corner belongs to
    std::vector<UvEdge> uvEdges;
    std::vector<WeldedEdge> weldedEdges;
    Vec2 boxLow, boxHigh; //!< box of all UVs in use; low > high when there are none

    double boxDiagonal() const { return boxHigh.x() >= boxLow.x() ? (boxHigh - boxLow).stableNorm() : 0; }
};

//! \param uv one row per corner; a non-finite row means that the corner has no UV
UvTopology findUvTopology(const MeshData &mesh, const UvMatrix &uv);

//! Charts by the rule of the file format: two faces on one welded 3D edge belong to one chart when their
//! UVs agree at both ends, to within 1e-6 of the diagonal of the UV box.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \pre uv.rows() == mesh.cornerCount()
ChartMap findCharts(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
