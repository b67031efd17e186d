#include "solver/metrics/uvmetrics.h"

#include "model/plain/chart.h"
#include "model/plain/densitygroups.h"
#include "model/plain/rigidpieces.h"
#include "solver/metrics/tilefigures.h"
#include "solver/metrics/uvdistortion.h"
#include "solver/metrics/uvgutter.h"
#include "solver/metrics/uvoverlaps.h"
#include "solver/metrics/uvtriangles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace autocuts::metrics {

namespace {

void countElements(const MeshData &mesh, const UvTopology &topology, const UvTriangles &triangles,
                   UvMetrics &metrics)
{
    metrics.faces = mesh.faceCount();
    metrics.triangles = triangles.count();
    metrics.vertices = mesh.vertexCount();
    for (int v = 0; v < mesh.vertexCount(); ++v)
        metrics.weldedVertices += mesh.vertexWeld[v] == v;
    for (bool hasUv : topology.faceHasUv)
        metrics.facesWithoutUv += !hasUv;
    for (bool zero : triangles.zeroArea)
        metrics.zeroAreaTriangles += zero;
    metrics.area3d = triangles.totalArea3d;
    metrics.uvArea = triangles.totalUvArea;
}

void measureEdges(const MeshData &mesh, const UvTopology &topology, UvMetrics &metrics)
{
    for (const WeldedEdge &edge : topology.weldedEdges) {
        const double length =
            (mesh.cornerPosition(edge.corner[0]) - mesh.cornerPosition(edge.corner[1])).norm();
        if (edge.sides == 1) {
            ++metrics.boundaryEdges;
            metrics.boundaryLength += length;
        } else if (edge.sides == 2) {
            ++metrics.interiorEdges;
            metrics.missingUvEdges += edge.sidesWithUv == 1;
            if (edge.copies == 2) {
                ++metrics.seamEdges;
                metrics.seamLength += length;
            }
        } else {
            ++metrics.nonManifoldEdges;
            if (edge.copies > 1)
                metrics.nonManifoldSeamLength += length;
        }
    }
    if (metrics.area3d > 0)
        metrics.seamNorm = metrics.seamLength / std::sqrt(metrics.area3d / std::numbers::pi);
}

void measureAlignment(const UvMatrix &uv, const UvTopology &topology, UvMetrics &metrics)
{
    const double slope = std::tan(std::numbers::pi / 180);
    double all = 0, aligned = 0;
    for (const UvEdge &edge : topology.uvEdges) {
        if (!edge.open)
            continue;
        const Vec2 along = (uv.row(edge.corner[1]) - uv.row(edge.corner[0])).cwiseAbs();
        all += along.norm();
        if (along.minCoeff() <= slope * along.maxCoeff())
            aligned += along.norm();
    }
    if (all > 0)
        metrics.axisAlignedShare = aligned / all;
}

void measureCharts(const UvTriangles &triangles, UvMetrics &metrics)
{
    metrics.charts = static_cast<int>(triangles.charts.size());
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const ChartSums &chart : triangles.charts) {
        metrics.mirroredCharts += chart.signedArea < 0;
        metrics.nonDiskCharts += chart.euler() != 1;
        if (!(chart.area3d > 0))
            continue;
        if (!(chart.uvArea > 1e-14 * triangles.totalUvArea)) {
            ++metrics.zeroUvCharts;
            continue;
        }
        const double density = std::sqrt(chart.uvArea / chart.targetArea);
        least = std::min(least, density);
        most = std::max(most, density);
    }
    if (most > 0)
        metrics.texelDensitySpread = most / least;
}

//! Per chart: false where a chart of the same stack is larger, or as large and before it.
std::vector<bool> coveringCharts(const std::vector<ChartSums> &charts, const std::vector<int> &stacks)
{
    std::vector<bool> covers(charts.size(), true);
    std::map<int, std::size_t> largest; // of each stack
    for (std::size_t chart = 0; chart < charts.size(); ++chart) {
        if (stacks[chart] == 0)
            continue;
        const auto [place, isFirst] = largest.try_emplace(stacks[chart], chart);
        if (isFirst)
            continue;
        const bool isLarger = charts[chart].uvArea > charts[place->second].uvArea;
        covers[isLarger ? std::exchange(place->second, chart) : chart] = false;
    }
    return covers;
}

void measureOverlaps(const UvMatrix &uv, const UvTopology &topology, const UvTriangles &triangles,
                     const UvMetricsOptions &options, UvMetrics &metrics)
{
    UvOverlapOptions search;
    search.faceFlags = options.faceFlags;
    search.job = options.job;
    const UvOverlapFigures found = measureUvOverlaps(uv, topology, triangles, search);
    if (!found.complete)
        return;
    metrics.overlapPairs = found.pairs;
    metrics.overlapPairsSameChart = found.sameChartPairs;
    metrics.stackedPairs = found.stackedPairs;
    metrics.overlappingTriangles = found.triangles;
    metrics.overlapAreaRatio = triangles.totalUvArea > 0 ? found.area / triangles.totalUvArea : 0;
}

void measurePacking(const UvTopology &topology, const UvMetricsOptions &options, UvMetrics &metrics)
{
    // How far a map may reach outside the tile and still count as inside.
    constexpr double tolerance = 1e-6;
    if (!(topology.boxDiagonal() > 0))
        return;
    const Vec2 &low = topology.boxLow;
    const Vec2 &high = topology.boxHigh;
    const Vec2 size = high - low;
    metrics.uvMin = low;
    metrics.uvMax = high;
    if (size.minCoeff() > 0)
        metrics.packingBox = metrics.coveredArea / (size.x() * size.y());
    metrics.packingSquare = metrics.coveredArea / (size.maxCoeff() * size.maxCoeff());
    const double room = std::min(1 - high.x(), options.tileHeight - high.y());
    metrics.inUnitSquare = low.minCoeff() >= -tolerance && room >= -tolerance;
}

} // namespace

UvMetrics measureUv(const MeshData &mesh, const UvMatrix &uv, const UvMetricsOptions &options)
{
    if (uv.rows() != mesh.cornerCount())
        throw std::invalid_argument("the UVs do not have one row per corner");
    const UvTopology topology = findUvTopology(mesh, uv);
    const UvTriangles triangles = collectUvTriangles(mesh, uv, topology);
    UvMetrics metrics;
    countElements(mesh, topology, triangles, metrics);
    measureEdges(mesh, topology, metrics);
    measureAlignment(uv, topology, metrics);
    measureCharts(triangles, metrics);
    measureDistortion(mesh, uv, triangles, densityGroups(mesh, topology.charts, uv, options.tileHeight),
                      metrics);
    const std::vector<int> stacks = stackOfCharts(topology.charts, options.faceFlags);
    const std::vector<bool> covers = coveringCharts(triangles.charts, stacks);
    for (std::size_t chart = 0; chart < covers.size(); ++chart)
        metrics.coveredArea += covers[chart] ? triangles.charts[chart].uvArea : 0;
    measurePacking(topology, options, metrics);
    measureTiles(mesh, uv, topology.charts, covers, options.tileHeight, metrics);
    metrics.borderGutterTexels = metrics.borderGutter * options.textureSize;
    if (options.overlaps)
        measureOverlaps(uv, topology, triangles, options, metrics);
    if (options.gutter) {
        const double gutter = smallestGutter(uv, topology, stacks);
        if (std::isfinite(gutter)) {
            metrics.minGutter = gutter;
            metrics.minGutterTexels = gutter * options.textureSize;
        }
    }
    return metrics;
}

UvMetrics measureShapes(const MeshData &mesh, const UvMatrix &uv, double tileHeight)
{
    UvMetricsOptions options;
    options.tileHeight = tileHeight;
    options.overlaps = options.gutter = false;
    return measureUv(mesh, uv, options);
}

} // namespace autocuts::metrics
