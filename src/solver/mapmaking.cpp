#include "solver/mapmaking.h"

#include "model/polygon.h"
#include "solver/chartmerge.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/overlapseparation.h"
#include "solver/overlapfree.h"
#include "solver/packing/islandgeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace autocuts {

namespace {

constexpr int relaxSteps = 60;
constexpr int mergeRounds = 4;
constexpr double densityReserve = 0.01; // of the distortion above 4
constexpr int mergeWork = 500'000;      // tries times triangles

//! Corner pairs that must not be cut: those that the user joined.
std::vector<bool> protectedEdges(const Snapshot &snapshot)
{
    std::vector<bool> joined(snapshot.mesh->edgePairs.size(), false);
    for (std::size_t p = 0; p < snapshot.pairState.size(); ++p) {
        if (snapshot.pairState[p] == PairState::Joined)
            joined[p / 2] = true;
    }
    return joined;
}

UvMatrix soupUv(const std::vector<double> &x)
{
    return Eigen::Map<const UvMatrix>(x.data(), static_cast<Eigen::Index>(x.size() / 2), 2);
}

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

//! Puts the polygons that lie on themselves in UV flat as they are in 3D, as charts of their own. That helps
//! unless they do so in 3D too.
void layFoldedFacesFlat(const Soup &soup, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<bool> folded(mesh.faceCount(), false);
    visitOverlaps(soupUv(map.x), {}, [&](int a, int b, double) {
        if (mesh.triangleFace[a] == mesh.triangleFace[b])
            folded[mesh.triangleFace[a]] = true;
        return true;
    });
    SeamedMap flat = map;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (!folded[face])
            continue;
        std::vector<Vec3> points;
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            points.push_back(mesh.cornerPosition(c) - mesh.cornerPosition(mesh.faceStart[face]));
        const Vec3 normal = polygonNormal(points).stableNormalized();
        const Vec3 u = normal.unitOrthogonal();
        const Vec3 v = normal.cross(u);
        for (int k = 0; k < 3; ++k) {
            const Vec3 &p = points[mesh.triangles[t][k] - mesh.faceStart[face]];
            const std::size_t at = 6 * static_cast<std::size_t>(t) + 2 * static_cast<std::size_t>(k);
            flat.x[at] = soup.scale * p.dot(u);
            flat.x[at + 1] = soup.scale * p.dot(v);
        }
        if (!(jacobianDeterminant(soup, flat.x.data(), t) > 0))
            return;
    }
    for (std::size_t e = 0; e < flat.cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (!pair.diagonal &&
            (folded[mesh.triangleFace[pair.triangle[0]]] || folded[mesh.triangleFace[pair.triangle[1]]]))
            flat.cut[e] = true;
    }
    map = std::move(flat);
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
    SeparationResult result =
        separateOverlaps(*soup.mesh, soupUv(map.x), map.cut, protectedEdges(snapshot), options);
    if (!result.complete)
        return false;
    map.cut = std::move(result.cut);
    if (result.unresolvedPairs > 0)
        layFoldedFacesFlat(soup, map);
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
