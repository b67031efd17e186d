// Charts of a UV map: connected sets of faces over uncut edges. Plain: no Qt.
//
// The document and the studio call the same thing a UV island.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! The chart of every face. A face without UVs has chart -1.
struct ChartMap
{
    std::vector<int> faceChart;
    int count = 0;

    //! The faces of each chart, in ascending order.
    std::vector<std::vector<int>> faces() const;
};

//! An edge of the UV map: polygon sides on one welded 3D edge whose UVs agree at both ends.
struct UvEdge
{
    //! The corners at the two ends of one of its sides; the lower welded vertex first.
    std::array<int, 2> corner;
    int chart = 0;
    bool open = false; //!< it has one side only, so it is on the border of its chart
};

//! A welded 3D edge and how its sides are stitched in UV space.
struct WeldedEdge
{
    std::array<int, 2> corner; //!< the corners at its two ends, the lower welded vertex first
    int sides = 0;             //!< number of polygon sides on it
    int sidesWithUv = 0;       //!< how many of these belong to faces with UVs
    int copies = 0;            //!< number of UvEdges that it has in the map
};

//! The charts, edges and vertices of a UV map, by the rule of findCharts().
struct UvTopology
{
    ChartMap charts;
    std::vector<bool> faceHasUv; //!< true when all corners of the face have finite UVs
    std::vector<int> cornerRoot; //!< first corner of the UV vertex that each corner belongs to
    std::vector<UvEdge> uvEdges;
    std::vector<WeldedEdge> weldedEdges;
    Vec2 boxLow, boxHigh; //!< bounding box of all UVs in use; low > high when there are none

    double boxDiagonal() const { return boxHigh.x() >= boxLow.x() ? (boxHigh - boxLow).stableNorm() : 0; }
};

//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \param apart per corner, true when the polygon side that starts there is a seam whatever its UVs are;
//! empty: none
UvTopology findUvTopology(const MeshData &mesh, const UvMatrix &uv, const std::vector<bool> &apart = {});

//! Finds the charts by the rule of the file format: two faces on one welded 3D edge belong to one chart when
//! their UVs agree at both ends, to within uvTolerance (1e-6) of the diagonal of the bounding box of all UVs.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \pre uv.rows() == mesh.cornerCount()
ChartMap findCharts(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
