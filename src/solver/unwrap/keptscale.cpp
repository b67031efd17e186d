#include "solver/unwrap/keptscale.h"

#include "model/plain/densitygroups.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace autocuts::unwrap {

std::vector<double> faceScales(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv, double scale,
                               double tileHeight)
{
    const DensityGroups groups = densityGroups(mesh, charts, uv, tileHeight);
    double uvArea = 0, target = 0;
    std::vector<double> targets(groups.density.size(), 0);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int chart = charts.faceChart[mesh.triangleFace[t]];
        if (chart >= 0 && groups.ofChart[chart] >= 0)
            targets[groups.ofChart[chart]] += mesh.targetArea(t);
    }
    for (std::size_t group = 0; group < targets.size(); ++group) {
        target += targets[group];
        uvArea += targets[group] * groups.density[group] * groups.density[group];
    }
    const double all = std::sqrt(uvArea / target);
    std::vector<double> scales(mesh.faceCount(), std::numeric_limits<double>::quiet_NaN());
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int chart = charts.faceChart[face], group = chart < 0 ? -1 : groups.ofChart[chart];
        if (group >= 0) // of one density, that of the map to the last bit
            scales[face] = targets.size() == 1 ? scale : scale * groups.density[group] / all;
    }
    return scales;
}

std::vector<double> chartScales(const MeshData &mesh, const ChartMap &charts,
                                const std::vector<double> &scales, double otherwise)
{
    std::vector<std::map<double, double>> areas(charts.count); // by scale
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t], chart = charts.faceChart[face];
        if (chart >= 0 && std::isfinite(scales[face]))
            areas[chart][scales[face]] += mesh.triangleArea[t];
    }
    std::vector<double> result(charts.count, otherwise);
    for (int chart = 0; chart < charts.count; ++chart) {
        const auto most = std::max_element(areas[chart].begin(), areas[chart].end(),
                                           [](const auto &a, const auto &b) { return a.second < b.second; });
        if (most != areas[chart].end())
            result[chart] = most->first;
    }
    return result;
}

void scaleCharts(const MeshData &mesh, const ChartMap &charts, const std::vector<double> &factors,
                 UvMatrix &uv)
{
    const auto faces = charts.faces();
    for (int chart = 0; chart < charts.count; ++chart) {
        if (factors[chart] == 1)
            continue;
        Eigen::AlignedBox2d box;
        for (const int face : faces[chart]) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                box.extend(Vec2(uv.row(c)));
        }
        const Eigen::RowVector2d middle = box.center().transpose();
        for (const int face : faces[chart]) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                uv.row(c) = middle + factors[chart] * (uv.row(c) - middle);
        }
    }
}

void keepScales(const Snapshot &snapshot, const ChartMap &charts, const PackJob &pack, double scale,
                UvMatrix &uv)
{
    const MeshData &mesh = *snapshot.mesh;
    const double before = layoutScale(mesh, *snapshot.uv);
    std::vector<double> factors = chartScales(
        mesh, charts,
        faceScales(mesh, findCharts(mesh, *snapshot.uv), *snapshot.uv, before, snapshot.tileHeight), before);
    const auto faces = charts.faces();
    for (int chart = 0; chart < charts.count; ++chart) {
        const IslandFlags flags =
            pack.faceFlags.empty() ? IslandFlags() : flagsOf(pack.faceFlags, faces[chart]);
        const bool stays =
            flags.locked + flags.stack + flags.group != 0 || std::ranges::any_of(faces[chart], [&](int face) {
                return (!pack.stays.empty() && pack.stays[face]) ||
                       std::ranges::any_of(pack.rectangles,
                                           [&](const PackRectangle &r) { return bool(r.faces[face]); });
            });
        factors[chart] = stays ? 1 : factors[chart] / scale;
    }
    scaleCharts(mesh, charts, factors, uv);
}

bool isSmaller(const MeshData &mesh, const UvMatrix &uv, double size)
{
    constexpr double sameSize = 1e-6; // the share that rounding may make
    return layoutScale(mesh, uv) < (1 - sameSize) * size;
}

} // namespace autocuts::unwrap
