#include "solver/unwrap/aligning.h"

#include "model/plain/uvlayout.h"
#include "solver/base/cornerat.h"
#include "solver/straight/straightening.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/packjob.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::unwrap {

namespace {

//! How much distortion straightening may add where the map is near the bound or above it. Chosen by hand.
constexpr double leastSpent = 0.05;

//! Per chart: its area in the map.
std::vector<double> mapAreas(const CutMesh &charts, const SeamedMap &map)
{
    std::vector<double> area(charts.chartCount, 0);
    for (std::size_t t = 0; t < charts.chart.size(); ++t) {
        const int c = 3 * static_cast<int>(t);
        const Vec2 a = cornerAt(map.x, c + 1) - cornerAt(map.x, c);
        const Vec2 b = cornerAt(map.x, c + 2) - cornerAt(map.x, c);
        area[charts.chart[t]] += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return area;
}

//! Scales the charts that nothing holds about the origin to these areas.
void scaleTo(const std::vector<double> &area, const CutMesh &charts, const std::vector<bool> &held,
             SeamedMap &map)
{
    std::vector<double> factor = mapAreas(charts, map);
    for (int i = 0; i < charts.chartCount; ++i) {
        const double wanted = std::sqrt(area[i] / factor[i]);
        factor[i] = std::isfinite(wanted) && wanted > 0 && (held.empty() || !held[i]) ? wanted : 1;
    }
    for (std::size_t c = 0; c < 3 * charts.chart.size(); ++c)
        cornerAt(map.x, static_cast<int>(c)) *= factor[charts.chart[c / 3]];
}

//! Moves islands aside, at their size, that lie on others now and did not before. Where there is no room for
//! them, a whole map is packed anew, which gives all of them one size.
void moveAside(const AlignInput &input, const ChartMap &charts, const JobContext &job, AlignResult &result)
{
    const MeshData &mesh = *input.snapshot.mesh;
    PackJob pack = steeredPackJob(input.snapshot, input.packing);
    pack.options.keepScale = true;
    std::vector<bool> now = misplacedFaces(mesh, charts, pack, result.uv, job);
    const std::vector<bool> before = misplacedFaces(mesh, charts, pack, *input.snapshot.uv, job);
    for (std::size_t face = 0; face < now.size(); ++face)
        now[face] = now[face] && !before[face];
    if (job.stopped() || std::find(now.begin(), now.end(), true) == now.end())
        return;
    pack.movable = std::move(now);
    if (packCharts(mesh, charts, pack, result.uv, job) || job.stopped())
        return;
    const std::vector<bool> &scope = input.snapshot.scope->faces;
    const bool isWhole = std::find(scope.begin(), scope.end(), false) == scope.end();
    result.noRoom =
        !isWhole || !packCharts(mesh, charts, steeredPackJob(input.snapshot, input.packing), result.uv, job);
}

} // namespace

AlignResult alignIslands(const AlignInput &input, const JobContext &job)
{
    AlignResult result;
    const std::optional<FreePart> part = FreePart::of(input.snapshot);
    result.nothingFree = !part;
    if (!part)
        return result;
    Snapshot own = part->withoutRectangles();
    own.editSteering().pairState.clear(); // the seams stay
    const std::shared_ptr<const Soup> soup = Soup::build(own.mesh);
    std::optional<SeamedMap> map = mapBefore(*soup, own);
    result.flipped = !map;
    if (!map)
        return result;
    const CutMesh charts(*own.mesh, map->cut);
    const std::vector<bool> held = heldCharts(own, charts);
    result.nothingFree = !held.empty() && std::find(held.begin(), held.end(), false) == held.end();
    if (result.nothingFree)
        return result;
    const SeamedMap given = *map;
    std::vector<double> onModel(charts.chartCount, 0);
    for (std::size_t t = 0; t < charts.chart.size(); ++t)
        onModel[charts.chart[t]] += std::numbers::pi * soup->weight[t];
    scaleTo(onModel, charts, held, *map);
    result.before = map->distortion(*soup);
    straight::StraightPlan plan = straight::StraightPlan::of(own);
    plan.aligned.assign(own.mesh->componentCount, true);
    plan.mirror = false;
    plan.up = WorldUp::Off;
    const double bound = std::max(input.maxDistortion, result.before + leastSpent);
    if (!straight::straighten(soup, own, plan, bound, *map, job.quiet()))
        return result;
    result.after = map->distortion(*soup);
    scaleTo(mapAreas(charts, given), charts, held, *map);
    straight::restoreCentres(*soup, own, given, *map);
    result.uv = part->wholeUv(own.uvScale * cornerUv(*soup, *map));
    moveAside(input, part->wholeCharts(chartsOf(*own.mesh, charts)), job, result);
    if (job.stopped())
        result.uv = UvMatrix();
    return result;
}

} // namespace autocuts::unwrap
