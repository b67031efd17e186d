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
#include <set>

namespace autocuts::unwrap {

namespace {

//! How much distortion straightening may add where the map is near the bound or above it. Chosen by hand.
constexpr double leastSpent = 0.05;
constexpr double sameScale = 1e-6; // maps of sizes that differ by this share are equally large

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

//! A job that packs islands, those that were aligned turned by right angles only.
PackJob packJobOf(const Snapshot &snapshot, const AlignInput &input)
{
    PackJob pack = steeredPackJob(snapshot, input.packing);
    pack.faceFlags.resize(snapshot.mesh->faceCount());
    for (std::size_t face = 0; face < pack.faceFlags.size(); ++face) {
        if (input.snapshot.scope->faces[face])
            pack.faceFlags[face].aligned = 1;
    }
    pack.density = packing::DensityBasis::Given;
    pack.options.keepScale = true;
    return pack;
}

//! The faces that belong to the tiles of some faces; all where the layout is not made of tiles.
std::vector<bool> facesOfTiles(const PackJob &pack, const std::vector<bool> &faces)
{
    if (pack.tiles.empty())
        return std::vector<bool>(faces.size(), true);
    std::set<int> tiles;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        if (faces[face])
            tiles.insert(pack.tiles[face]);
    }
    std::vector<bool> result;
    for (const int tile : pack.tiles)
        result.push_back(tiles.contains(tile));
    return result;
}

//! The faces of islands that lie on others, wherever these are.
std::vector<bool> overlappingFaces(const MeshData &mesh, const ChartMap &charts, PackJob pack,
                                   const UvMatrix &uv, const JobContext &job)
{
    pack.tiles.clear();
    const double farthest = std::max(1.0, uv.cwiseAbs().maxCoeff<Eigen::PropagateNumbers>());
    pack.options.lower.setConstant(-2 * farthest);
    pack.options.upper.setConstant(2 * farthest);
    return misplacedFaces(mesh, charts, pack, uv, job);
}

//! Moves islands aside, at their size, that lie on others now and did not before. Where there is no room for
//! them, those of the scope are packed, then all of their tiles, and at last these at a smaller scale.
void moveAside(const AlignInput &input, const ChartMap &charts, const JobContext &job, AlignResult &result)
{
    const MeshData &mesh = *input.snapshot.mesh;
    PackJob pack = packJobOf(input.snapshot, input);
    std::vector<bool> now = misplacedFaces(mesh, charts, pack, result.uv, job);
    const std::vector<bool> before = misplacedFaces(mesh, charts, pack, *input.snapshot.uv, job);
    // An island that reached over the border before may lie on others only now.
    const std::vector<bool> onOthers = overlappingFaces(mesh, charts, pack, result.uv, job);
    const std::vector<bool> wasOnOthers = overlappingFaces(mesh, charts, pack, *input.snapshot.uv, job);
    for (std::size_t face = 0; face < now.size(); ++face)
        now[face] = (now[face] && !before[face]) || (onOthers[face] && !wasOnOthers[face]);
    if (job.stopped() || std::find(now.begin(), now.end(), true) == now.end())
        return;
    Snapshot everywhere = input.snapshot;
    everywhere.scope = nullptr;
    PackJob others = packJobOf(everywhere, input);
    others.movable = facesOfTiles(others, now);
    pack.movable = std::move(now);
    PackJob own = pack;
    own.movable = input.snapshot.scope->faces;
    for (const PackJob *way : {&pack, &own, &others}) {
        if (packCharts(mesh, charts, *way, result.uv, job) || job.stopped())
            return;
    }
    others.options.keepScale = false;
    others.keepScaleIfPossible = true;
    const double size = layoutScale(mesh, result.uv);
    result.noRoom = !packCharts(mesh, charts, others, result.uv, job);
    result.madeSmaller = layoutScale(mesh, result.uv) < (1 - sameScale) * size;
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
