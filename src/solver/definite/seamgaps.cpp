#include "solver/definite/seamgaps.h"

#include "solver/base/cornerat.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace autocuts::definite {

namespace {

//! Width of a gap in mean edge lengths, and its least width relative to the diagonal of the map: ten times
//! the distance (a millionth of the diagonal) below which readers of UVs merge corners. The first was chosen
//! by hand.
constexpr double gapOfEdge = 1e-3;
constexpr double gapOfMap = 1e-5;

//! For each chart the charts that touch it along a seam without a gap.
std::vector<std::vector<int>> touchingCharts(const MeshData &mesh, const SeamedMap &map,
                                             const CutMesh &charts, double gap)
{
    const auto apart = [&map](const std::array<int, 2> &corners) {
        const Vec2 between = cornerAt(map.x, corners[0]) - cornerAt(map.x, corners[1]);
        return std::hypot(between.x(), between.y());
    };
    std::vector<std::vector<int>> touching(charts.chartCount);
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const int a = charts.chart[pair.triangle[0]], b = charts.chart[pair.triangle[1]];
        if (a != b && std::max(apart(pair.corner[0]), apart(pair.corner[1])) < gap) {
            touching[a].push_back(b);
            touching[b].push_back(a);
        }
    }
    return touching;
}

} // namespace

double seamGap(double meanEdge, double diagonal)
{
    return std::max(gapOfEdge * meanEdge, gapOfMap * diagonal);
}

void openSeams(const Soup &soup, const Snapshot &snapshot, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    const CutMesh charts(mesh, map.cut);
    const auto points = rowsOf(map.x);
    const double diagonal = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
    const double gap = seamGap(soup.meanEdgeLength, diagonal);
    const std::vector<std::vector<int>> touching = touchingCharts(mesh, map, charts, gap / 2);

    std::vector<double> importance(charts.chartCount, 0);
    for (int t = 0; t < mesh.triangleCount(); ++t)
        importance[charts.chart[t]] += soup.weight[t];
    const double all = std::accumulate(importance.begin(), importance.end(), 0.0);
    for (const Pin &pin : snapshot.steering->pins)
        importance[charts.chart[pin.soupCorner / 3]] += all;
    std::vector<int> order(charts.chartCount);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return importance[a] > importance[b]; });

    // Each chart moves right by the smallest number of gaps that no touching chart before it has.
    std::vector<int> gaps(charts.chartCount, -1);
    for (const int chart : order) {
        std::vector<bool> taken(touching[chart].size() + 1, false);
        for (const int other : touching[chart]) {
            if (gaps[other] >= 0 && gaps[other] < static_cast<int>(taken.size()))
                taken[gaps[other]] = true;
        }
        gaps[chart] = static_cast<int>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    }
    for (int corner = 0; corner < mesh.soupCornerCount(); ++corner)
        cornerAt(map.x, corner).x() += gap * gaps[charts.chart[corner / 3]];
}

} // namespace autocuts::definite
