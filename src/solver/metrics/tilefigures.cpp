#include "solver/metrics/tilefigures.h"

#include "model/plain/udimtiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace autocuts::metrics {

namespace {

//! Sums over the charts of one tile.
struct TileSums
{
    int faces = 0;
    std::set<int> charts;
    double uvArea = 0, covered = 0, target = 0;
    double toBorder = std::numeric_limits<double>::infinity();
};

std::map<int, TileSums> sumsOf(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts,
                               const std::vector<bool> &covers, const std::vector<int> &tiles,
                               double tileHeight)
{
    std::map<int, TileSums> sums;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (tiles[face] == 0)
            continue;
        TileSums &sum = sums[tiles[face]];
        ++sum.faces;
        sum.charts.insert(charts.faceChart[face]);
        const Eigen::AlignedBox2d tile = udimTile(tiles[face], tileHeight);
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            const Vec2 place = uv.row(c);
            sum.toBorder =
                std::min({sum.toBorder, (place - tile.min()).minCoeff(), (tile.max() - place).minCoeff()});
        }
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int tile = tiles[mesh.triangleFace[t]];
        if (tile == 0)
            continue;
        const auto &[a, b, c] = mesh.triangles[t];
        TileSums &sum = sums[tile];
        const double area = std::abs(cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)))) / 2;
        sum.uvArea += area;
        if (covers[charts.faceChart[mesh.triangleFace[t]]])
            sum.covered += area;
        sum.target += mesh.targetArea(t);
    }
    return sums;
}

} // namespace

void measureTiles(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts,
                  const std::vector<bool> &covers, double tileHeight, UvMetrics &metrics)
{
    const TileLayout layout = findTiles(mesh, charts, uv, tileHeight);
    const std::vector<int> tiles = layout.ofFaces(charts);
    double toBorder = std::numeric_limits<double>::infinity();
    for (const auto &[tile, sum] : sumsOf(mesh, uv, charts, covers, tiles, tileHeight)) {
        TileFigures figures{tile, sum.faces, static_cast<int>(sum.charts.size())};
        figures.efficiency = sum.covered / tileHeight;
        if (sum.target > 0)
            figures.density = std::sqrt(sum.uvArea / sum.target);
        metrics.tiles.push_back(figures);
        toBorder = std::min(toBorder, sum.toBorder);
    }
    for (int chart = 0; chart < charts.count; ++chart) {
        if (layout.hasTiles && layout.sticksOut[chart])
            metrics.chartsOffTile.emplace_back(chart, layout.tile[chart]);
    }
    const auto off = std::count(layout.sticksOut.begin(), layout.sticksOut.end(), true);
    metrics.inTiles = charts.count > 0 && off == 0;
    if (!metrics.inTiles)
        return;
    metrics.packingUnit = metrics.coveredArea / (tileHeight * static_cast<double>(metrics.tiles.size()));
    metrics.borderGutter = toBorder;
}

} // namespace autocuts::metrics
