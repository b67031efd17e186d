#include "model/plain/densitygroups.h"

#include "model/plain/udimtiles.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts {

namespace {

//! Largest difference in a group. Chosen by hand: islands of a tile that were packed differ by up to 2 %
//! where they have curved parts.
constexpr double tolerance = 0.025;

struct Areas
{
    double uv = 0, target = 0; //!< target: see MeshData::targetArea()

    double density() const { return std::sqrt(uv / target); }
    bool isUsable() const { return uv > 0 && target > 0 && std::isfinite(density()) && density() > 0; }
};

//! The density that islands with half of the area have at most. \param charts numbers of charts
double medianDensity(std::vector<int> charts, const std::vector<Areas> &areas)
{
    std::stable_sort(charts.begin(), charts.end(),
                     [&](int a, int b) { return areas[a].density() < areas[b].density(); });
    double all = 0, below = 0;
    for (const int chart : charts)
        all += areas[chart].target;
    for (const int chart : charts) {
        below += areas[chart].target;
        if (below >= 0.5 * all)
            return areas[chart].density();
    }
    return areas[charts.back()].density();
}

} // namespace

DensityGroups densityGroups(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                            double tileHeight)
{
    std::vector<Areas> areas(charts.count);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int chart = charts.faceChart[mesh.triangleFace[t]];
        if (chart < 0)
            continue;
        const auto &[a, b, c] = mesh.triangles[t];
        areas[chart].uv += std::abs(cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)))) / 2;
        areas[chart].target += mesh.targetArea(t);
    }
    const TileLayout layout = findTiles(mesh, charts, uv, tileHeight);
    std::map<int, std::vector<int>> ofTile;
    for (int chart = 0; chart < charts.count; ++chart) {
        if (areas[chart].isUsable())
            ofTile[layout.hasTiles ? layout.tile[chart] : 0].push_back(chart);
    }
    DensityGroups groups{std::vector<int>(charts.count, -1), {}};
    std::vector<Areas> sums;
    for (const auto &[tile, own] : ofTile) {
        const double median = medianDensity(own, areas);
        int common = -1;
        for (const int chart : own) {
            const bool isCommon = std::abs(areas[chart].density() / median - 1) < tolerance;
            int &group = groups.ofChart[chart];
            group = isCommon && common >= 0 ? common : static_cast<int>(sums.size());
            if (group == static_cast<int>(sums.size()))
                sums.emplace_back();
            common = isCommon ? group : common;
            sums[group].uv += areas[chart].uv;
            sums[group].target += areas[chart].target;
        }
    }
    for (const Areas &sum : sums)
        groups.density.push_back(sum.density());
    return groups;
}

} // namespace autocuts
