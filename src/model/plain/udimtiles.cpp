#include "model/plain/udimtiles.h"

#include "model/plain/packingsettings.h"
#include "model/plain/uvlayout.h"

#include <cmath>
#include <set>

namespace autocuts {

namespace {

constexpr int perRow = 10;
//! How far an island may reach over the border of its tile. Chosen by hand far above rounding.
constexpr double tolerance = 1e-6;

//! Column and row of the tile with the point.
Vec2 cellOf(const Vec2 &point, double tileHeight)
{
    return {std::floor(point.x()), std::floor(point.y() / tileHeight)};
}

Eigen::AlignedBox2d boxOf(const Vec2 &cell, double tileHeight)
{
    const Vec2 size(1, tileHeight);
    return {cell.cwiseProduct(size), (cell + Vec2::Ones()).cwiseProduct(size)};
}

//! The tile that a box lies in; 0 when it lies in none.
int tileOf(const Eigen::AlignedBox2d &box, double tileHeight)
{
    if (box.isEmpty())
        return 0;
    const Vec2 corner = cellOf(box.center(), tileHeight);
    if (corner.x() < 0 || corner.x() >= perRow || corner.y() < 0)
        return 0;
    const double tile = PackingSettings::firstTile + corner.x() + perRow * corner.y();
    const Eigen::AlignedBox2d own = boxOf(corner, tileHeight);
    const bool fits = (box.min().array() >= own.min().array() - tolerance).all() &&
                      (box.max().array() <= own.max().array() + tolerance).all();
    return fits && tile <= PackingSettings::lastTile ? static_cast<int>(tile) : 0;
}

} // namespace

Eigen::AlignedBox2d udimTile(int tile, double tileHeight)
{
    const int index = tile - PackingSettings::firstTile;
    return boxOf(Vec2(index % perRow, index / perRow), tileHeight);
}

Eigen::AlignedBox2d tileAt(const Vec2 &point, double tileHeight)
{
    return boxOf(cellOf(point, tileHeight), tileHeight);
}

std::vector<int> islandTiles(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                             double tileHeight)
{
    std::vector<Eigen::AlignedBox2d> boxes(charts.count);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; charts.faceChart[face] >= 0 && c < mesh.faceStart[face + 1]; ++c)
            boxes[charts.faceChart[face]].extend(Vec2(uv.row(c)));
    }
    std::vector<int> tiles(mesh.faceCount(), 0);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (charts.faceChart[face] >= 0)
            tiles[face] = tileOf(boxes[charts.faceChart[face]], tileHeight);
    }
    return tiles;
}

std::vector<int> usedTiles(const std::vector<int> &tiles, const std::vector<bool> &faces)
{
    std::set<int> used;
    for (std::size_t face = 0; face < tiles.size(); ++face) {
        if (tiles[face] > 0 && (faces.empty() || faces[face]))
            used.insert(tiles[face]);
    }
    return {used.begin(), used.end()};
}

std::vector<int> udimTiles(const MeshData &mesh, const UvMatrix &uv, double tileHeight)
{
    // Most layouts lie in one tile; then the islands need not be found.
    if (const int tile = tileOf(layoutBox(uv), tileHeight); tile != 0 && uv.allFinite())
        return std::vector<int>(mesh.faceCount(), tile);
    const ChartMap charts = findCharts(mesh, uv);
    std::vector<int> tiles = islandTiles(mesh, charts, uv, tileHeight);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (charts.faceChart[face] >= 0 && tiles[face] == 0)
            return std::vector<int>(mesh.faceCount(), 0);
    }
    return tiles;
}

BakedTiles tilesToBake(const MeshData &mesh, const UvMatrix &uv, double tileHeight)
{
    constexpr int firstTile = 1001;
    const std::vector<int> ofFace = islandTiles(mesh, findCharts(mesh, uv), uv, tileHeight);
    BakedTiles tiles{usedTiles(ofFace), static_cast<int>(std::count(ofFace.begin(), ofFace.end(), 0))};
    if (tiles.numbers.empty())
        tiles.numbers.push_back(firstTile);
    return tiles;
}

} // namespace autocuts
