// The machine-readable report on a UV map.
#pragma once

#include "model/plain/meshdata.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <limits>
#include <optional>

namespace autocuts {

//! What a report says. Figures that are not known stay NaN or empty and are written as null. The figures mean
//! what UvMetrics says; this struct repeats them because the model does not know the solver.
struct MapReport
{
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    using Count = std::optional<qint64>;

    // The stable keys that scripts rely on.
    Count triangles, charts;
    double seamLength = unknown, seamNorm = unknown;
    double symDirichlet = unknown, symDirichletMax = unknown;
    Count flipped, overlapPairs;
    double overlapAreaRatio = unknown, packingEfficiency = unknown, minGutterTexels = unknown;
    double seconds = unknown;
    Count iterations;
    double lambda = unknown, delta = unknown;
    QString status; //!< "done", "time_limit", "interrupted", ...

    // More about the map.
    QString input, output, layout;
    Count textureSize;
    Count faces, seamEdges, symDirichletInfinite, uvDegenerate, mirroredCharts, nonDiskCharts;
    Count facesWithoutUv, zeroAreaTriangles;
    double symDirichletP99 = unknown, symDirichletScale = unknown;
    double l2Stretch = unknown, angleDistortion = unknown, areaDistortion = unknown;
    double texelDensitySpread = unknown, packingBox = unknown, minGutter = unknown;
    double borderGutterTexels = unknown;
    std::optional<bool> inUnitSquare;

    // The mesh as it was read.
    std::optional<MeshReport> mesh;
    QStringList notes; //!< readable sentences: what was found and what was done
};

//! JSON, indented, ending in a line feed: every key always there, always in the same order. Numbers are as
//! short as they can be and still read back exactly.
QByteArray reportJson(const MapReport &report);

} // namespace autocuts
