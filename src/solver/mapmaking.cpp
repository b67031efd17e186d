#include "solver/mapmaking.h"

#include "solver/chartmerge.h"
#include "solver/foldedunits.h"
#include "solver/overlap/overlapseparation.h"
#include "solver/overlapfree.h"
#include "solver/packing/islandgeometry.h"

#include <algorithm>
#include <vector>

namespace autocuts {

namespace {

constexpr int relaxSteps = 60;
constexpr int mergeRounds = 4;
constexpr double densityReserve = 0.01; // of the distortion above 4
constexpr int mergeWork = 500'000;      // tries times triangles

//! Relaxes a map as far as it may: without covering itself, unless that is allowed.
void relaxAsAllowed(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, bool allowOverlaps,
                    SeamedMap &map, const std::atomic<bool> *stop)
{
    SeamedMap relaxed = map;
    relaxMap(soup, snapshot, relaxed, relaxSteps, stop);
    if (!allowOverlaps && coversItself(*soup, relaxed)) {
        // The free way led over itself; the guarded one is slower.
        relaxed = map;
        relaxWithoutOverlaps(soup, snapshot, relaxed, relaxSteps, stop);
        if (coversItself(*soup, relaxed))
            return;
    }
    map = std::move(relaxed);
}

//! Joins charts and closes seams as long as the bound leaves room for it.
void shortenSeams(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                  const MapMakingOptions &options, SeamedMap &map, const std::atomic<bool> *stop)
{
    MergeOptions merge;
    // Giving every chart the same texel density costs a little at the end.
    merge.maxDistortion = options.maxDistortion - densityReserve * (options.maxDistortion - 4);
    merge.costPerLength = options.costPerLength;
    merge.allowOverlaps = options.allowOverlaps;
    // A try costs time in proportion to the mesh.
    merge.tries = std::clamp(mergeWork / soup->triangleCount(), 10, 300);
    merge.cancel = stop;
    for (int round = 0; round < mergeRounds && !(stop && stop->load()); ++round) {
        const int closed = mergeCharts(soup, snapshot, map, merge) + zipSeams(soup, snapshot, map, merge);
        if (closed == 0)
            break;
        relaxAsAllowed(soup, snapshot, options.allowOverlaps, map, stop);
    }
}

} // namespace

std::optional<MadeMap> makeMap(const Solver &solver, const MapMakingOptions &options,
                               const std::atomic<bool> *cancel)
{
    const auto cancelled = [cancel] { return cancel && cancel->load(std::memory_order_relaxed); };
    const std::shared_ptr<const Soup> soup = solver.sharedSoup();
    const Snapshot &snapshot = solver.snapshot();
    MadeMap result;
    result.map = finishMap(soup, snapshot, solver.coordinates(), cancel);
    relaxMap(soup, snapshot, result.map, relaxSteps, cancel);
    if (!options.allowOverlaps) {
        if (!removeOverlaps(*soup, snapshot, result.map, cancel))
            return std::nullopt;
        relaxAsAllowed(soup, snapshot, false, result.map, cancel);
    }
    result.seedDistortion = result.map.distortion(*soup);
    shortenSeams(soup, snapshot, options, result.map, cancel);
    if (!snapshot.placesIslands())
        equalizeDensity(*soup, result.map);
    if (cancelled())
        return std::nullopt;
    return result;
}

void equalizeDensity(const Soup &soup, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    UvMatrix uv = cornerUv(soup, map);
    equalizeTexelDensity(mesh, chartsOf(mesh, CutMesh(mesh, map.cut)), uv);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        map.x[2 * static_cast<std::size_t>(c)] = uv(mesh.cornerOfSoup(c), 0);
        map.x[2 * static_cast<std::size_t>(c) + 1] = uv(mesh.cornerOfSoup(c), 1);
    }
}

ChartMap chartsOf(const MeshData &mesh, const CutMesh &state)
{
    ChartMap charts;
    charts.count = state.chartCount;
    charts.faceChart.assign(mesh.faceCount(), -1);
    for (int t = 0; t < mesh.triangleCount(); ++t)
        charts.faceChart[mesh.triangleFace[t]] = state.chart[t];
    return charts;
}

bool removeOverlaps(const Soup &soup, const Snapshot &snapshot, SeamedMap &map,
                    const std::atomic<bool> *cancel)
{
    SeparationOptions options;
    options.cancel = cancel;
    if (!snapshot.pairWeight.empty()) {
        options.pairWeight.resize(map.cut.size());
        for (std::size_t e = 0; e < map.cut.size(); ++e)
            options.pairWeight[e] = snapshot.edgeWeight(e);
    }
    std::vector<bool> joined(map.cut.size());
    for (std::size_t e = 0; e < map.cut.size(); ++e)
        joined[e] = snapshot.isJoined(e);
    SeparationResult result = separateOverlaps(*soup.mesh, rowsOf(map.x), map.cut, joined, options);
    if (!result.complete)
        return false;
    map.cut = std::move(result.cut);
    if (result.unresolvedPairs > 0)
        unfoldUnits(soup, snapshot, map, cancel);
    return true;
}

UvMatrix cornerUv(const Soup &soup, const SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        uv(mesh.cornerOfSoup(c), 0) = map.x[2 * static_cast<std::size_t>(c)];
        uv(mesh.cornerOfSoup(c), 1) = map.x[2 * static_cast<std::size_t>(c) + 1];
    }
    return uv;
}

} // namespace autocuts
