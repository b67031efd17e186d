#include "solver/packing/islandgeometry.h"

#include "solver/packing/layout.h"

#include <algorithm>
#include <tuple>

namespace autocuts::packing {

namespace {

bool isLocked(const std::vector<bool> &locked, int chart)
{
    return !locked.empty() && locked[chart];
}

//! Makes one point per distinct pair of welded vertex and UV in every chart. \returns per corner the index of
//! its point within the island, -1 without a chart
std::vector<int> collectPoints(const MeshData &mesh, const UvMatrix &uv, const std::vector<int> &cornerChart,
                               std::vector<PackIsland> &islands)
{
    std::vector<int> order;
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        if (cornerChart[c] >= 0)
            order.push_back(c);
    }
    const auto key = [&](int c) {
        return std::tuple(cornerChart[c], mesh.vertexWeld[mesh.cornerVertex[c]], uv(c, 0), uv(c, 1));
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const auto ka = key(a), kb = key(b);
        return ka < kb || (ka == kb && a < b);
    });
    std::vector<int> point(mesh.cornerCount(), -1);
    for (std::size_t i = 0; i < order.size(); ++i) {
        auto &points = islands[cornerChart[order[i]]].points;
        if (i == 0 || key(order[i]) != key(order[i - 1]))
            points.push_back(uv.row(order[i]).transpose());
        point[order[i]] = static_cast<int>(points.size()) - 1;
    }
    return point;
}

//! Finds the boundary of every chart: sides of faces that no other face of the chart shares.
void collectBoundary(const MeshData &mesh, const std::vector<int> &faceChart, const std::vector<int> &point,
                     std::vector<PackIsland> &islands)
{
    std::vector<std::array<int, 3>> sides; // chart, lower point, higher point
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (faceChart[f] < 0)
            continue;
        const int start = mesh.faceStart[f], end = mesh.faceStart[f + 1];
        for (int c = start; c < end; ++c) {
            const auto [low, high] = std::minmax(point[c], point[c + 1 < end ? c + 1 : start]);
            sides.push_back({faceChart[f], low, high});
        }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
        while (j < sides.size() && sides[j] == sides[i])
            ++j;
        if (j == i + 1)
            islands[sides[i][0]].boundary.push_back({sides[i][1], sides[i][2]});
    }
}

struct ChartSize
{
    double uvArea = 0, area = 0;
    Eigen::AlignedBox2d box;
};

std::vector<ChartSize> measureCharts(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv)
{
    std::vector<ChartSize> sizes(charts.count);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int chart = charts.faceChart[mesh.triangleFace[t]];
        if (chart < 0)
            continue;
        std::array<Vec2, 3> p;
        for (int k = 0; k < 3; ++k) {
            p[k] = uv.row(mesh.triangles[t][k]).transpose();
            sizes[chart].box.extend(p[k]);
        }
        sizes[chart].uvArea += 0.5 * std::abs(cross2(p[0], p[1], p[2]));
        sizes[chart].area += mesh.targetArea(t);
    }
    return sizes;
}

//! Ratio of the singular values of a triangle's map from the surface below which it keeps its shape, and
//! scale beside that of the others that do. Rigid regions that have settled are nearer by far. Chosen by
//! hand.
constexpr double keptShape = 1.001, keptScale = 1.001;
//! Share of a chart's area in triangles that keep their shape at one scale, from which these alone decide on
//! its density. Chosen by hand; organic charts have less.
constexpr double leastKept = 0.2;

//! True when a triangle has the same shape in the map, at any scale.
bool keepsShape(const MeshData &mesh, int t, const std::array<Vec2, 3> &p)
{
    const auto &[a, b, c] = mesh.triangles[t];
    const Vec3 u = mesh.cornerPosition(b) - mesh.cornerPosition(a),
               v = mesh.cornerPosition(c) - mesh.cornerPosition(a);
    const double length = u.norm(), along = u.dot(v) / length, height = u.cross(v).norm() / length;
    if (!(length > 0 && height > 0))
        return false;
    const Vec2 x = (p[1] - p[0]) / length, y = (p[2] - p[0] - along * x) / height;
    const double squares = x.squaredNorm() + y.squaredNorm(), det = std::abs(x.x() * y.y() - x.y() * y.x());
    return squares < (keptShape + 1 / keptShape) * det;
}

//! The sizes that the density of the charts is read from. Where a good part of a chart keeps its shape at one
//! scale, that part decides: the density of flat faces is what artists see, however the rest is stretched.
std::vector<ChartSize> decisiveSizes(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv)
{
    std::vector<ChartSize> sizes = measureCharts(mesh, charts, uv);
    struct Part
    {
        double scale, uvArea, area;
    };
    std::vector<std::vector<Part>> kept(charts.count);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int chart = charts.faceChart[mesh.triangleFace[t]];
        if (chart < 0)
            continue;
        std::array<Vec2, 3> p;
        for (int k = 0; k < 3; ++k)
            p[k] = uv.row(mesh.triangles[t][k]).transpose();
        const double uvArea = 0.5 * std::abs(cross2(p[0], p[1], p[2])), area = mesh.targetArea(t);
        if (uvArea > 0 && area > 0 && keepsShape(mesh, t, p))
            kept[chart].push_back({std::sqrt(uvArea / area), uvArea, area});
    }
    for (int i = 0; i < charts.count; ++i) {
        std::stable_sort(kept[i].begin(), kept[i].end(),
                         [](const Part &a, const Part &b) { return a.scale < b.scale; });
        double all = 0, below = 0;
        for (const Part &part : kept[i])
            all += part.area;
        const auto median = std::find_if(kept[i].begin(), kept[i].end(),
                                         [&](const Part &part) { return (below += part.area) >= 0.5 * all; });
        double uvArea = 0, area = 0;
        for (const Part &part : kept[i]) {
            if (part.scale > median->scale / keptScale && part.scale < median->scale * keptScale) {
                uvArea += part.uvArea;
                area += part.area;
            }
        }
        if (area >= leastKept * sizes[i].area && area > 0) {
            sizes[i].uvArea = uvArea;
            sizes[i].area = area;
        }
    }
    return sizes;
}

} // namespace

std::vector<PackIsland> makePackIslands(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts,
                                        const std::vector<bool> &locked)
{
    std::vector<PackIsland> islands(charts.count);
    std::vector<int> cornerChart(mesh.cornerCount(), -1);
    for (int f = 0; f < mesh.faceCount(); ++f)
        std::fill(cornerChart.begin() + mesh.faceStart[f], cornerChart.begin() + mesh.faceStart[f + 1],
                  charts.faceChart[f]);
    const std::vector<int> point = collectPoints(mesh, uv, cornerChart, islands);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int chart = charts.faceChart[mesh.triangleFace[t]];
        const auto &c = mesh.triangles[t];
        if (chart >= 0)
            islands[chart].triangles.push_back({point[c[0]], point[c[1]], point[c[2]]});
    }
    collectBoundary(mesh, charts.faceChart, point, islands);
    for (int i = 0; i < charts.count; ++i)
        islands[i].locked = isLocked(locked, i);
    return islands;
}

void applyPlacements(const PackResult &result, const MeshData &mesh, const ChartMap &charts, UvMatrix &uv,
                     const std::vector<bool> &locked)
{
    if (!result.complete)
        return;
    std::vector<Turn> turns;
    for (const PackPlacement &placement : result.placements)
        turns.emplace_back(placement.angle, result.scale);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int chart = charts.faceChart[f];
        if (chart < 0 || isLocked(locked, chart))
            continue;
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            const Vec2 p = uv.row(c).transpose();
            uv.row(c) = (turns[chart](p) + result.placements[chart].translation).transpose();
        }
    }
}

void equalizeTexelDensity(const MeshData &mesh, const ChartMap &charts, UvMatrix &uv,
                          const std::vector<bool> &locked, DensityBasis basis)
{
    const std::vector<ChartSize> sizes =
        basis == DensityBasis::FlatParts ? decisiveSizes(mesh, charts, uv) : measureCharts(mesh, charts, uv);
    const auto usable = [&](int i) { return sizes[i].uvArea > 0 && sizes[i].area > 0; };
    double uvArea = 0, area = 0;
    bool anyLocked = false;
    for (int i = 0; i < charts.count; ++i)
        anyLocked = anyLocked || (isLocked(locked, i) && usable(i));
    for (int i = 0; i < charts.count; ++i) {
        if (usable(i) && (!anyLocked || isLocked(locked, i))) {
            uvArea += sizes[i].uvArea;
            area += sizes[i].area;
        }
    }
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int chart = charts.faceChart[f];
        if (chart < 0 || !usable(chart) || isLocked(locked, chart))
            continue;
        const double factor = std::sqrt(uvArea / area * sizes[chart].area / sizes[chart].uvArea);
        const Vec2 middle = 0.5 * (sizes[chart].box.min() + sizes[chart].box.max());
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            const Vec2 p = uv.row(c).transpose();
            uv.row(c) = (middle + factor * (p - middle)).transpose();
        }
    }
}

} // namespace autocuts::packing
