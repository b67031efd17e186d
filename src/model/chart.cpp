#include "model/chart.h"

#include "model/unionfind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace autocuts {

namespace {

struct Side
{
    int low, high;              //!< welded vertices
    int cornerLow, cornerHigh;
    int face;
};

} // namespace

std::vector<std::vector<int>> ChartMap::faces() const
{
    std::vector<std::vector<int>> result(count);
    for (int f = 0; f < static_cast<int>(faceChart.size()); ++f) {
        if (faceChart[f] >= 0)
            result[faceChart[f]].push_back(f);
    }
    return result;
}

ChartMap findCharts(const MeshData &mesh, const UvMatrix &uv)
{
    const int faceCount = mesh.faceCount();
    std::vector<bool> hasUv(faceCount, true);
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    std::vector<Side> sides;
    sides.reserve(mesh.cornerCount());
    for (int f = 0; f < faceCount; ++f) {
        const int start = mesh.faceStart[f];
        const int end = mesh.faceStart[f + 1];
        for (int c = start; c < end; ++c)
            hasUv[f] = hasUv[f] && uv.row(c).allFinite();
        if (!hasUv[f])
            continue;
        for (int c = start; c < end; ++c) {
            const int d = c + 1 < end ? c + 1 : start;
            const int a = mesh.vertexWeld[mesh.cornerVertex[c]];
            const int b = mesh.vertexWeld[mesh.cornerVertex[d]];
            low = low.cwiseMin(uv.row(c).transpose());
            high = high.cwiseMax(uv.row(c).transpose());
            if (a < b)
                sides.push_back({a, b, c, d, f});
            else if (b < a)
                sides.push_back({b, a, d, c, f});
        }
    }
    const double tolerance = sides.empty() ? 0 : 1e-6 * (high - low).stableNorm();
    std::sort(sides.begin(), sides.end(), [](const Side &a, const Side &b) {
        return std::tie(a.low, a.high, a.cornerLow) < std::tie(b.low, b.high, b.cornerLow);
    });
    const auto agree = [&](int a, int b) { return (uv.row(a) - uv.row(b)).stableNorm() <= tolerance; };

    UnionFind sets(faceCount);
    std::vector<const Side *> clusters;
    for (std::size_t i = 0; i < sides.size();) {
        clusters.clear();
        std::size_t j = i;
        for (; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high; ++j) {
            const auto same = std::find_if(clusters.begin(), clusters.end(), [&](const Side *s) {
                return agree(s->cornerLow, sides[j].cornerLow) && agree(s->cornerHigh, sides[j].cornerHigh);
            });
            if (same == clusters.end())
                clusters.push_back(&sides[j]);
            else
                sets.unite((*same)->face, sides[j].face);
        }
        i = j;
    }

    ChartMap charts;
    charts.faceChart.assign(faceCount, -1);
    for (int f = 0; f < faceCount; ++f) {
        if (!hasUv[f])
            continue;
        const int root = sets.find(f);
        charts.faceChart[f] = root == f ? charts.count++ : charts.faceChart[root];
    }
    return charts;
}

} // namespace autocuts
