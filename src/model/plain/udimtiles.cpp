#include "model/plain/udimtiles.h"

#include "model/plain/chart.h"
#include "model/plain/packingsettings.h"
#include "model/plain/uvlayout.h"

#include <Eigen/Geometry>

#include <cmath>

namespace autocuts {

namespace {

constexpr int perRow = 10;
//! How far an island may reach over the border of its tile. Chosen by hand far above rounding.
constexpr double tolerance = 1e-6;

//! The tile that a box lies in; 0 when it lies in none.
int tileOf(const Eigen::AlignedBox2d &box)
{
    if (box.isEmpty())
        return 0;
    const Vec2 corner = box.center().array().floor();
    if (corner.x() < 0 || corner.x() >= perRow || corner.y() < 0)
        return 0;
    const double tile = PackingSettings::firstTile + corner.x() + perRow * corner.y();
    const bool fits = (box.min().array() >= corner.array() - tolerance).all() &&
                      (box.max().array() <= corner.array() + 1 + tolerance).all();
    return fits && tile <= PackingSettings::lastTile ? static_cast<int>(tile) : 0;
}

} // namespace

Vec2 udimCorner(int tile)
{
    const int index = tile - PackingSettings::firstTile;
    return Vec2(index % perRow, index / perRow);
}

std::vector<int> udimTiles(const MeshData &mesh, const UvMatrix &uv)
{
    // Most layouts lie in one tile; then the islands need not be found.
    if (const int tile = tileOf(layoutBox(uv)); tile != 0 && uv.allFinite())
        return std::vector<int>(mesh.faceCount(), tile);
    const ChartMap charts = findCharts(mesh, uv);
    std::vector<Eigen::AlignedBox2d> boxes(charts.count);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; charts.faceChart[face] >= 0 && c < mesh.faceStart[face + 1]; ++c)
            boxes[charts.faceChart[face]].extend(Vec2(uv.row(c)));
    }
    std::vector<int> tiles(mesh.faceCount(), 0);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (charts.faceChart[face] < 0)
            continue;
        tiles[face] = tileOf(boxes[charts.faceChart[face]]);
        if (tiles[face] == 0)
            return std::vector<int>(mesh.faceCount(), 0);
    }
    return tiles;
}

} // namespace autocuts
