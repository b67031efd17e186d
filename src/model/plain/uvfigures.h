// The figures that describe a UV map.
#pragma once

#include "model/plain/types.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace autocuts::metrics {

//! Value of a figure that does not exist (no UVs, one chart only, outside the first tile): not a number.
inline constexpr double missingFigure = std::numeric_limits<double>::quiet_NaN();

//! The figures of one UDIM tile.
struct TileFigures
{
    int tile = 0;                   //!< its number, 1001 and more
    int faces = 0, charts = 0;      //!< of the charts that belong to it
    double density = missingFigure; //!< length in UV units of a unit of the model, by the areas
    double efficiency = 0;          //!< the part of the tile that its charts take
};

//! Figures of a UV map. Definitions and tolerances follow an independent measuring program, so that figures
//! can be compared. Vertices are welded where their positions are exactly equal. Polygons are split as in
//! MeshData: by a fan from fanApex() when there is one. Of the others, those with triangles that this turns
//! over in the map are split as they lie in the map, if no triangle is turned over then. Diagonals are never
//! edges. Signed UV area is positive when the UV triangle has the winding of its 3D face; totals sum |area|.
//! Distortion, stretch and texel density are relative to the texel weights of the mesh: 3D triangles count as
//! if their sides were multiplied by them. 3D lengths and areas are in mesh units, UV ones in units of the
//! texture square.
struct UvMetrics
{
    int faces = 0, triangles = 0, vertices = 0, weldedVertices = 0;
    int zeroAreaTriangles = 0; //!< 3D area <= 1e-10 * longest edge squared; left out of the distortion
    int facesWithoutUv = 0;
    int charts = 0, nonDiskCharts = 0, mirroredCharts = 0;
    int zeroUvCharts = 0; //!< charts with a UV area of 0
    int interiorEdges = 0, boundaryEdges = 0, nonManifoldEdges = 0;
    int missingUvEdges = 0; //!< interior edges with UVs on one side only
    int seamEdges = 0;
    double area3d = 0;
    double seamLength = 0; //!< 3D length of interior edges whose sides differ in UV, each counted once
    double seamNorm = missingFigure; //!< seamLength / sqrt(area3d / pi)
    double boundaryLength = 0;
    double nonManifoldSeamLength = 0;
    //! Share of the length in UV of the charts' borders, seams from both sides, whose direction is within 1
    //! degree of horizontal or vertical.
    double axisAlignedShare = missingFigure;

    int flipped = 0;      //!< triangles whose sign differs from that of their chart
    int uvDegenerate = 0; //!< |UV area| < 1e-14 of the total; not counted as flips
    double flippedUvAreaRatio = 0;

    double symDirichlet = missingFigure; //!< area-weighted mean at the scale that minimises it; 4 = isometric
    //! The same where tiles, and islands that were scaled, keep the density that they have: each of the
    //! groups of densityGroups() at the scale that suits it.
    double tileDirichlet = missingFigure;
    double symDirichletMax = missingFigure, symDirichletP99 = missingFigure;
    double symDirichletScale = missingFigure; //!< that scale: UVs multiplied by it have the size of the mesh
    int symDirichletInfinite = 0;             //!< collapsed triangles, left out of all distortion means
    double symDirichletInfiniteAreaRatio = 0;
    double l2Stretch = missingFigure;          //!< Sander et al. 2001; 1 = isometric
    double angleDistortion = missingFigure;    //!< mean ratio of the singular values; 1 = conformal
    double areaDistortion = missingFigure;     //!< mean of max(r, 1/r), r = UV area share / 3D area share
    double texelDensitySpread = missingFigure; //!< largest / smallest texel density of a chart

    double overlapAreaRatio = missingFigure; //!< summed intersection areas of all triangle pairs / UV area
    std::int64_t overlapPairs = -1;          //!< pairs above 1e-9 of the UV area; -1: not measured
    std::int64_t overlapPairsSameChart = -1;
    std::int64_t overlappingTriangles = -1; //!< triangles in these pairs
    std::int64_t stackedPairs = -1; //!< pairs of islands of one stack; not in the other figures of overlaps

    double uvArea = 0;
    double coveredArea = 0; //!< the same, with only the largest island of each stack
    Vec2 uvMin = Vec2::Constant(missingFigure), uvMax = Vec2::Constant(missingFigure);
    bool inUnitSquare = false;            //!< in the first tile of the texture, within 1e-6
    double packingBox = missingFigure;    //!< covered area / area of the bounding box
    double packingSquare = missingFigure; //!< covered area / square of the longer side of the bounding box
    //! Every chart lies in a UDIM tile, within 1e-6. Then packing and distances to the border are of the
    //! tiles in use.
    bool inTiles = false;
    double packingUnit = missingFigure;     //!< part of the area of the tiles in use that charts take
    double minGutter = missingFigure;       //!< smallest UV distance between borders of different charts
    double minGutterTexels = missingFigure; //!< the same at the texture size
    double borderGutter = missingFigure;    //!< smallest distance of a chart to the border of its tile
    double borderGutterTexels = missingFigure;

    std::vector<TileFigures> tiles; //!< the tiles to which charts belong, ascending; see udimtiles.h
    //! Charts of a layout that is made of tiles of which a part lies outside of their tile, and that tile.
    std::vector<std::pair<int, int>> chartsOffTile;

    //! Per chart, numbered as by findCharts(): symDirichlet of the chart alone, at the scale that suits it.
    std::vector<double> chartSymDirichlet;

    // Per triangle of the mesh, for heat-maps.
    std::vector<double>
        triangleSymDirichlet; //!< at symDirichletScale; infinite when collapsed, NaN without UVs
    std::vector<double> triangleAreaStretch; //!< log of UV area share / 3D area share; > 0: too large in UV
    std::vector<bool> triangleFlipped;
};

} // namespace autocuts::metrics
