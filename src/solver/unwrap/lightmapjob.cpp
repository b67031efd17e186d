#include "solver/unwrap/lightmapjob.h"

#include "solver/unwrap/keptscale.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts::unwrap {

namespace {

//! Densities that differ by less than this share are equal. Chosen by hand far above rounding.
constexpr double sameDensity = 1e-6;

//! Makes the islands of all tiles as small as those of the tile with the least texel density.
void evenOut(const MeshData &mesh, PackJob pack, UvMatrix &uv, const JobContext &job)
{
    std::map<int, std::pair<double, double>> areas; // by tile: in the map, and as it should be
    for (int t = 0; t < mesh.triangleCount() && !pack.tiles.empty(); ++t) {
        const auto &[a, b, c] = mesh.triangles[t];
        auto &[inMap, target] = areas[pack.tiles[mesh.triangleFace[t]]];
        const double area = std::abs(cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)))) / 2;
        inMap += std::isfinite(area) ? area : 0;
        target += std::isfinite(area) ? mesh.targetArea(t) : 0;
    }
    std::map<int, double> density;
    for (const auto &[tile, area] : areas) {
        if (area.first > 0 && area.second > 0)
            density[tile] = std::sqrt(area.first / area.second);
    }
    if (density.size() < 2)
        return;
    const double least =
        std::ranges::min_element(density, {}, [](const auto &d) { return d.second; })->second;
    UvMatrix even = uv;
    const ChartMap charts = findCharts(mesh, uv);
    std::vector<double> factors(charts.count, 1);
    bool changes = false;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const auto own = density.find(pack.tiles[face]);
        if (charts.faceChart[face] < 0 || own == density.end() || own->second < (1 + sameDensity) * least)
            continue;
        factors[charts.faceChart[face]] = least / own->second;
        changes = true;
    }
    if (!changes)
        return;
    scaleCharts(mesh, charts, factors, even);
    pack.options.keepScale = true;
    pack.density = packing::DensityBasis::Given;
    if (packCharts(mesh, charts, pack, even, job))
        uv = std::move(even);
}

} // namespace

SeparateResult makeLightmap(const Snapshot &snapshot, const packing::PackOptions &options,
                            const JobContext &job)
{
    using Outcome = SeparateResult::Outcome;
    Snapshot map;
    map.mesh = snapshot.mesh;
    map.uv = snapshot.uv;
    map.uvScale = snapshot.uvScale;
    map.tileHeight = snapshot.tileHeight;
    map.keepTiles = snapshot.keepTiles;
    const PackJob pack = steeredPackJob(map, options);
    SeparateResult result = separateMap(map, pack, job);
    const JobContext packing = job.part(0, 1, JobStage::Packing);
    if (result.outcome == Outcome::NoOverlaps) { // the gutters may be too narrow, and the sizes differ
        const bool packed = packCharts(*map.mesh, findCharts(*map.mesh, result.uv), pack, result.uv, packing);
        result.outcome = packed ? Outcome::Done : job.stopped() ? Outcome::Stopped : Outcome::NoRoom;
    }
    if (result.outcome == Outcome::Done)
        evenOut(*map.mesh, pack, result.uv, packing);
    return result;
}

} // namespace autocuts::unwrap
