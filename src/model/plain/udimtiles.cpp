#include "model/plain/udimtiles.h"

#include "model/plain/packingsettings.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace autocuts {

namespace {

constexpr int perRow = 10;
//! How far an island may reach over the border of its tile. Chosen by hand far above rounding.
constexpr double tolerance = 1e-6;
//! Share of its area that an island at home has in its tile, and share of all area that such islands have in
//! a layout that is made of tiles. Chosen by hand: an island that covers two tiles, or four, is not at home.
constexpr double homeShare = 2.0 / 3, leastAtHome = 0.5;
//! An island that reaches over more tiles than this along an axis is not looked at tile by tile.
constexpr double mostCells = 16;
//! Nor is one that lies further out than this: there are no tiles, and far enough out not even whole numbers.
constexpr double farthest = 1e6;

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

//! The number of the tile in a column and row; 0 where no tile is.
int numberOf(const Vec2 &cell)
{
    const double tile = PackingSettings::firstTile + cell.x() + perRow * cell.y();
    const bool isThere =
        cell.x() >= 0 && cell.x() < perRow && cell.y() >= 0 && tile <= PackingSettings::lastTile;
    return isThere ? static_cast<int>(tile) : 0;
}

//! The one of several tiles that is nearest to a column and row; of equally near ones, the first.
int nearestOf(const std::set<int> &tiles, const Vec2 &cell)
{
    const auto distance = [&](int tile) { return (udimTile(tile, 1).min() - cell).squaredNorm(); };
    return *std::min_element(tiles.begin(), tiles.end(),
                             [&](int a, int b) { return distance(a) < distance(b); });
}

bool fits(const Eigen::AlignedBox2d &box, const Eigen::AlignedBox2d &tile)
{
    return (box.min().array() >= tile.min().array() - tolerance).all() &&
           (box.max().array() <= tile.max().array() + tolerance).all();
}

//! The tile that a box lies in; 0 when it lies in none.
int tileOf(const Eigen::AlignedBox2d &box, double tileHeight)
{
    if (box.isEmpty())
        return 0;
    const Vec2 cell = cellOf(box.center(), tileHeight);
    return fits(box, boxOf(cell, tileHeight)) ? numberOf(cell) : 0;
}

//! The part of a convex polygon on one side of a line along an axis. \param sign 1: at least the value, -1:
//! at most
std::vector<Vec2> clipped(const std::vector<Vec2> &polygon, int axis, double value, int sign)
{
    std::vector<Vec2> inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = sign * (from[axis] - value), b = sign * (to[axis] - value);
        if (a >= 0)
            inside.push_back(from);
        if ((a < 0) != (b < 0))
            inside.push_back(from + a / (a - b) * (to - from));
    }
    return inside;
}

//! Area of the part of a triangle in a box.
double areaIn(const std::array<Vec2, 3> &triangle, const Eigen::AlignedBox2d &box)
{
    std::vector<Vec2> polygon(triangle.begin(), triangle.end());
    for (int axis = 0; axis < 2; ++axis) {
        polygon = clipped(polygon, axis, box.min()[axis], 1);
        polygon = clipped(polygon, axis, box.max()[axis], -1);
    }
    double area = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        area += cross2(polygon[0], polygon[i - 1], polygon[i]) / 2;
    return std::abs(area);
}

//! An island and the tiles that it reaches.
struct Reach
{
    Eigen::AlignedBox2d box;
    double area = 0;
    std::map<std::pair<double, double>, double> areaInCell; //!< by row and column

    Vec2 size(double tileHeight) const
    {
        return cellOf(box.max(), tileHeight) - cellOf(box.min(), tileHeight);
    }
};

//! \param charts of the UVs
std::vector<Reach> reachesOf(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                             double tileHeight)
{
    std::vector<Reach> reaches(charts.count);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; charts.faceChart[face] >= 0 && c < mesh.faceStart[face + 1]; ++c)
            reaches[charts.faceChart[face]].box.extend(Vec2(uv.row(c)));
    }
    std::vector<bool> looksAt(charts.count);
    for (int chart = 0; chart < charts.count; ++chart) {
        const Reach &reach = reaches[chart];
        looksAt[chart] = !reach.box.isEmpty() && tileOf(reach.box, tileHeight) == 0 &&
                         reach.size(tileHeight).maxCoeff() < mostCells &&
                         reach.box.min().minCoeff() > -farthest && reach.box.max().maxCoeff() < farthest;
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int chart = charts.faceChart[mesh.triangleFace[t]];
        if (chart < 0)
            continue;
        const auto &[a, b, c] = mesh.triangles[t];
        const std::array<Vec2, 3> corners{uv.row(a), uv.row(b), uv.row(c)};
        reaches[chart].area += std::abs(cross2(corners[0], corners[1], corners[2])) / 2;
        if (!looksAt[chart])
            continue;
        Eigen::AlignedBox2d box;
        for (const Vec2 &corner : corners)
            box.extend(corner);
        const Vec2 low = cellOf(box.min(), tileHeight), high = cellOf(box.max(), tileHeight);
        for (double y = low.y(); y <= high.y(); ++y) {
            for (double x = low.x(); x <= high.x(); ++x)
                reaches[chart].areaInCell[{y, x}] += areaIn(corners, boxOf({x, y}, tileHeight));
        }
    }
    return reaches;
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

std::vector<int> TileLayout::ofFaces(const ChartMap &charts) const
{
    std::vector<int> tiles;
    for (const int chart : charts.faceChart)
        tiles.push_back(chart >= 0 ? tile[chart] : 0);
    return tiles;
}

TileLayout findTiles(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv, double tileHeight)
{
    TileLayout layout;
    std::vector<Vec2> cells; // per chart: column and row of most of it
    std::set<int> homes;     // the tiles in which islands are at home
    double all = 0, atHome = 0;
    for (const Reach &reach : reachesOf(mesh, charts, uv, tileHeight)) {
        const int whole = tileOf(reach.box, tileHeight);
        Vec2 cell = reach.box.isEmpty() ? Vec2(0, 0) : cellOf(reach.box.center(), tileHeight);
        double most = whole > 0 ? reach.area : 0;
        for (const auto &[place, area] : reach.areaInCell) {
            if (area > (1 + tolerance) * most) { // of equal shares, that of the lowest number
                most = area;
                cell = Vec2(place.second, place.first);
            }
        }
        all += reach.area;
        if (numberOf(cell) > 0 && reach.area > 0 && most >= homeShare * reach.area) {
            atHome += reach.area;
            homes.insert(numberOf(cell));
        }
        layout.tile.push_back(whole);
        layout.sticksOut.push_back(whole == 0);
        cells.push_back(cell);
    }
    layout.hasTiles = !homes.empty() && atHome >= leastAtHome * all;
    // A map that was made for a square texture, and islands of which lie over the borders of lower tiles now.
    const Eigen::AlignedBox2d square(Vec2(0, 0), Vec2(1, 1)), box = layoutBox(uv);
    const bool anyOut =
        std::find(layout.sticksOut.begin(), layout.sticksOut.end(), true) != layout.sticksOut.end();
    if (tileHeight < 1 && anyOut && !box.isEmpty() && square.contains(box))
        layout.hasTiles = false;
    for (int chart = 0; layout.hasTiles && chart < charts.count; ++chart) {
        const int tile = numberOf(cells[chart]);
        layout.tile[chart] = tile > 0 ? tile : nearestOf(homes, cells[chart]);
    }
    return layout;
}

std::vector<int> islandTiles(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                             double tileHeight)
{
    return findTiles(mesh, charts, uv, tileHeight).ofFaces(charts);
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
    const TileLayout layout = findTiles(mesh, charts, uv, tileHeight);
    return layout.hasTiles ? layout.ofFaces(charts) : std::vector<int>(mesh.faceCount(), 0);
}

BakedTiles tilesToBake(const MeshData &mesh, const UvMatrix &uv, double tileHeight)
{
    const ChartMap charts = findCharts(mesh, uv);
    const TileLayout layout = findTiles(mesh, charts, uv, tileHeight);
    BakedTiles tiles{usedTiles(layout.ofFaces(charts))};
    for (const int chart : charts.faceChart)
        tiles.facesOutside += chart < 0 || layout.sticksOut[chart];
    if (tiles.numbers.empty())
        tiles.numbers.push_back(PackingSettings::firstTile);
    return tiles;
}

} // namespace autocuts
