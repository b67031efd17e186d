// The machine-readable report on a UV map.
#pragma once

#include "model/plain/meshdata.h"
#include "model/transfer/uvtransfer.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <limits>
#include <optional>
#include <vector>

namespace autocuts {

//! The content of a report. Unknown figures stay NaN or empty and are written as null. The figures have the
//! same meaning as in metrics::UvMetrics.
struct MapReport
{
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    using Count = std::optional<qint64>;

    // Stable keys: scripts rely on them.
    Count triangles, charts;
    double seamLength = unknown, seamNorm = unknown;
    double symDirichlet = unknown, symDirichletMax = unknown;
    Count flipped, overlapPairs;
    double overlapAreaRatio = unknown, packingEfficiency = unknown, minGutterTexels = unknown;
    double seconds = unknown;
    Count iterations;
    double lambda = unknown, delta = unknown;
    double hardSurfaceShare = unknown; //!< of the area, in parts that the unwrap took for hard surfaces
    QString status;                    //!< "done", "bound_missed", "time_limit" or "interrupted"

    // More figures of the map.
    QString input, output, layout;
    QString uvSet; //!< name of the set that was measured
    Count textureSize, textureHeight;
    Count faces, seamEdges, symDirichletInfinite, uvDegenerate, mirroredCharts, nonDiskCharts;
    Count facesWithoutUv, zeroAreaTriangles, overlappingTriangles, stackedPairs;
    Count texelDensityWeights; //!< faces with a painted texel weight; distortion is relative to these
    Count facesWithoutUvArea;  //!< faces with area on the model that have a triangle without area in the map
    double symDirichletP99 = unknown, symDirichletScale = unknown;
    double symDirichletTiles = unknown; //!< each tile, and each island of a density of its own, at its scale
    double l2Stretch = unknown, angleDistortion = unknown, areaDistortion = unknown;
    double texelDensitySpread = unknown, axisAlignedShare = unknown, packingBox = unknown,
           minGutter = unknown;
    double borderGutterTexels = unknown;
    std::optional<bool> inUnitSquare;

    //! The figures of one object or material.
    struct Part
    {
        QString name; //!< as in the file; may be empty
        qint64 faces = 0, charts = 0;
        double symDirichlet = unknown;      //!< mean of that of its islands, by area
        double texelDensity = unknown;      //!< texels per unit of the model
        double packingEfficiency = unknown; //!< the part of a tile that its islands take
    };
    std::vector<Part> objects, materials; //!< in the order of the file; faces without a material are last

    //! The figures of one UDIM tile.
    struct Tile
    {
        int number = 0; //!< 1001 and more
        qint64 faces = 0, charts = 0;
        double texelDensity = unknown;      //!< texels per unit of the model
        double packingEfficiency = unknown; //!< the part of the tile that its islands take
    };
    std::vector<Tile> tiles; //!< to which islands belong, ascending
    //! An island of a layout of tiles that does not lie in its tile as a whole.
    struct OffTile
    {
        int island = 0; //!< from 1 on
        int tile = 0;   //!< to which it belongs
    };
    std::vector<OffTile> offTile;
    std::optional<bool> inTiles;                       //!< every island lies in a tile
    std::optional<transfer::TransferFigures> transfer; //!< of the command that makes maps this way

    // The mesh as it was read.
    std::optional<MeshReport> mesh;
    QStringList notes; //!< sentences for people: what was found and what was done
};

//! Indented JSON that ends with a line feed. All keys are always present, in the same order. Numbers have the
//! fewest digits from which the same value can be read.
QByteArray reportJson(const MapReport &report);

} // namespace autocuts
