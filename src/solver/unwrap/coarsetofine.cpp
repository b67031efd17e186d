#include "solver/unwrap/coarsetofine.h"

#include "solver/base/cornerat.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/multires/maprefiner.h"
#include "solver/preference/seampreference.h"
#include "solver/search/anchoring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace autocuts::unwrap {

namespace {

// Chosen by hand; their effect has not been measured.

//! Meshes of more triangles than this are coarsened first.
constexpr int largeMesh = 25'000;
//! The coarse mesh has at most this share of the triangles, else coarsening is not worth the effort.
constexpr double leastReduction = 0.6;
//! Bounds for the coarse map, as shares of (bound - 4). The distortion of the fine map usually gets lower,
//! because a finer mesh can bend more freely. The second share is tried when the fine map misses the bound.
constexpr double coarseShares[] = {1.4, 0.9};
constexpr int fineSteps = 30; // relaxation steps on the fine mesh, at most

using PointPair = std::pair<int, int>;

PointPair endsOf(const multires::ProgressiveMesh &mesh, int side)
{
    return std::minmax(mesh.point(side), mesh.point(multires::ProgressiveMesh::next(side)));
}

//! The user's cuts and joins: per edge, given by the points at its ends, the state at each end.
using Decisions = std::map<PointPair, std::array<std::pair<int, PairState>, 2>>;

//! Per edge pair: true when the user cut or joined it at either end.
std::vector<bool> decidedEdges(const Snapshot &snapshot)
{
    const std::vector<PairState> &states = snapshot.steering->pairState;
    std::vector<bool> decided(snapshot.mesh->edgePairs.size(), false);
    for (std::size_t p = 0; p < states.size(); ++p) {
        if (states[p] != PairState::Free)
            decided[p / 2] = true;
    }
    return decided;
}

//! Per edge pair: true when its ends must stay: decided edges, and those around triangles with a pin.
std::vector<bool> keptEdges(const Snapshot &snapshot, std::vector<bool> kept)
{
    std::vector<bool> pinned(snapshot.mesh->triangleCount(), false);
    for (const Pin &pin : snapshot.steering->pins)
        pinned[pin.soupCorner / 3] = true;
    for (std::size_t e = 0; e < kept.size() && !snapshot.steering->pins.empty(); ++e) {
        const auto [a, b] = snapshot.mesh->edgePairs[e].triangle;
        kept[e] = kept[e] || pinned[a] || pinned[b];
    }
    return kept;
}

Decisions decisionsOf(const Snapshot &snapshot, const multires::ProgressiveMesh &fine,
                      const std::vector<bool> &decided)
{
    Decisions decisions;
    for (std::size_t e = 0; e < decided.size(); ++e) {
        if (!decided[e])
            continue;
        const EdgePair &pair = snapshot.mesh->edgePairs[e];
        const int side = 3 * pair.triangle[0] + pair.side(0);
        auto &ends = decisions[endsOf(fine, side)];
        for (int end = 0; end < 2; ++end)
            ends[end] = {fine.point(pair.corner[end][0]), snapshot.steering->pairState[2 * e + end]};
    }
    return decisions;
}

//! Mean painted weight around each point of the fine mesh.
std::vector<double> pointWeights(const Snapshot &snapshot, const multires::ProgressiveMesh &fine)
{
    if (snapshot.steering->pairWeight.empty())
        return {};
    std::vector<double> sum(fine.pointCount(), 0.0), count(fine.pointCount(), 0.0);
    for (std::size_t p = 0; p < snapshot.steering->pairWeight.size(); ++p) {
        const int point = fine.point(snapshot.mesh->edgePairs[p / 2].corner[p % 2][0]);
        sum[point] += snapshot.steering->pairWeight[p];
        ++count[point];
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] = count[i] > 0 ? sum[i] / count[i] : 1;
    return sum;
}

//! Solver units of the coarse mesh per solver unit of the fine one.
double unitOf(const MeshData &coarse, const MeshData &fine)
{
    return std::sqrt(fine.area / coarse.area);
}

//! Adds the pins that act on triangles of the coarse mesh.
void addPins(const Snapshot &snapshot, const std::vector<int> &triangles, const MeshData &mesh,
             Steering &steering)
{
    if (!snapshot.placesIslands())
        return;
    const double unit = unitOf(mesh, *snapshot.mesh);
    std::vector<int> coarseTriangle(snapshot.mesh->triangleCount(), -1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        coarseTriangle[triangles[t]] = static_cast<int>(t);
    const auto coarseCorner = [&](int corner) {
        const int t = coarseTriangle[corner / 3];
        return t < 0 ? -1 : 3 * t + corner % 3;
    };
    for (Pin pin : snapshot.steering->pins) {
        pin.soupCorner = coarseCorner(pin.soupCorner);
        pin.target *= unit;
        if (pin.soupCorner >= 0)
            steering.pins.push_back(pin);
    }
}

//! A snapshot of the coarse mesh with the settings, cuts, joins, weights and pins of the fine one.
Snapshot coarseSnapshot(const Snapshot &snapshot, const std::shared_ptr<const MeshData> &mesh,
                        const multires::ProgressiveMesh &points, const std::vector<int> &triangles,
                        const Decisions &decisions, const std::vector<double> &weights)
{
    Snapshot coarse;
    coarse.mesh = mesh;
    coarse.settings = snapshot.settings;
    Steering &steering = coarse.editSteering();
    addPins(snapshot, triangles, *mesh, steering);
    if (!decisions.empty())
        steering.pairState.assign(mesh->cornerPairCount(), PairState::Free);
    if (!weights.empty())
        steering.pairWeight.assign(mesh->cornerPairCount(), 1.0);
    for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
        const EdgePair &pair = mesh->edgePairs[e];
        const auto pointOf = [&](int corner) { return points.point(3 * triangles[corner / 3] + corner % 3); };
        const int ends[2] = {pointOf(pair.corner[0][0]), pointOf(pair.corner[1][0])};
        const auto found = decisions.find(std::minmax(ends[0], ends[1]));
        for (int end = 0; end < 2; ++end) {
            if (!weights.empty())
                steering.pairWeight[2 * e + end] = 0.5 * (weights[ends[0]] + weights[ends[1]]);
            for (int i = 0; found != decisions.end() && i < 2; ++i) {
                if (found->second[i].first == ends[end])
                    steering.pairState[2 * e + end] = found->second[i].second;
            }
        }
    }
    return coarse;
}

//! Writes coordinates and cut flags of the coarse map to the remaining triangles of the fine mesh.
//! \param scale of the map
void setCoarseMap(const MeshData &coarse, const SeamedMap &map, double scale,
                  const std::vector<int> &triangles, const multires::ProgressiveMesh &points,
                  multires::MapRefiner &refiner)
{
    const auto uvOf = [&](int soupCorner) { return Vec2(cornerAt(map.x, soupCorner)); };
    for (int t = 0; t < coarse.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) {
            refiner.uv[3 * triangles[t] + k] = scale * uvOf(3 * t + k);
            refiner.cut[3 * triangles[t] + k] = 1;
        }
    }
    for (std::size_t e = 0; e < coarse.edgePairs.size(); ++e) {
        const EdgePair &pair = coarse.edgePairs[e];
        const int a = 3 * triangles[pair.triangle[0]] + pair.side(0);
        const int b = 3 * triangles[pair.triangle[1]] + pair.side(1);
        if (points.across(a) == b)
            refiner.cut[a] = refiner.cut[b] = map.cut[e];
    }
}

//! Total area of a map.
double areaOf(const SeamedMap &map)
{
    double area = 0;
    for (int c = 0; c < static_cast<int>(map.x.size() / 2); c += 3)
        area += 0.5 * cross2(cornerAt(map.x, c), cornerAt(map.x, c + 1), cornerAt(map.x, c + 2));
    return area;
}

//! Moves seams that run along polygon diagonals to polygon edges. At each such diagonal, the triangle at the
//! end of the polygon moves to the other side of the seam.
void leaveDiagonals(const Soup &soup, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<std::vector<int>> edgesOf(mesh.triangleCount());
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        for (const int t : mesh.edgePairs[e].triangle)
            edgesOf[t].push_back(static_cast<int>(e));
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (!pair.diagonal || !map.cut[e])
            continue;
        // The triangle with fewer diagonals moves; its edges that are no diagonals become seams.
        const auto diagonals = [&](int t) {
            return std::count_if(edgesOf[t].begin(), edgesOf[t].end(),
                                 [&](int other) { return mesh.edgePairs[other].diagonal; });
        };
        const int which = diagonals(pair.triangle[1]) < diagonals(pair.triangle[0]) ? 1 : 0;
        const int moving = pair.triangle[which];
        for (const int other : edgesOf[moving])
            map.cut[other] = other != static_cast<int>(e) && !mesh.edgePairs[other].diagonal;
        std::array<Vec2, 2> end, rest;
        for (int i = 0; i < 2; ++i) {
            const int own = pair.corner[i][which], other = pair.corner[i][1 - which];
            cornerAt(map.x, own) = cornerAt(map.x, other);
            end[i] = cornerAt(map.x, own);
            rest[i] = cornerAt(soup.restShape[moving], own % 3);
        }
        // The third corner keeps its position at rest relative to the diagonal, turned and scaled with it.
        const int third = 3 * moving + 3 - pair.corner[0][which] % 3 - pair.corner[1][which] % 3;
        const Vec2 far = cornerAt(soup.restShape[moving], third % 3);
        const Vec2 from = rest[1] - rest[0], to = end[1] - end[0], arm = far - rest[0];
        const double norm = from.squaredNorm();
        const double c = from.dot(to) / norm, s = (from.x() * to.y() - from.y() * to.x()) / norm;
        cornerAt(map.x, third) =
            Vec2(end[0].x() + c * arm.x() - s * arm.y(), end[0].y() + s * arm.x() + c * arm.y());
    }
}

//! The refined map as coordinates and cut flags of the fine mesh.
SeamedMap fineMap(const Soup &soup, const multires::MapRefiner &refiner)
{
    SeamedMap map;
    map.x.resize(soup.coordinateCount());
    for (std::size_t c = 0; c < refiner.uv.size(); ++c)
        cornerAt(map.x, static_cast<int>(c)) = refiner.uv[c];
    const MeshData &mesh = *soup.mesh;
    map.cut.resize(mesh.edgePairs.size());
    for (std::size_t e = 0; e < map.cut.size(); ++e)
        map.cut[e] = refiner.cut[3 * mesh.edgePairs[e].triangle[0] + mesh.edgePairs[e].side(0)] != 0;
    leaveDiagonals(soup, map);
    return map;
}

//! Makes the carried map valid: stitches what does not fit together, relaxes the map, removes overlaps unless
//! they are allowed, and gives all charts one texel density. \returns false when overlaps cannot be removed
bool makeUsable(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                const UnwrapOptions &options, SeamedMap &map, const JobContext &job)
{
    if (!map.validate(*soup).empty())
        map = definite::stitchTo(soup, snapshot, map.cut, map.x, job);
    SeamedMap relaxed = map;
    definite::relaxMap(soup, snapshot, relaxed, fineSteps, job);
    if (job.stopped()) {
        // There is no time to choose between two maps.
        map = std::move(relaxed);
        if (!options.allowOverlaps && definite::coversItself(*soup, map) &&
            !definite::removeOverlaps(*soup, snapshot, map))
            return false;
    } else if (options.allowOverlaps || !definite::coversItself(*soup, relaxed)) {
        map = std::move(relaxed);
    } else {
        // The relaxed map overlaps itself. Relax again with boundaries barred; if that misses the bound, cut
        // the overlaps off the freely relaxed map instead.
        if (definite::coversItself(*soup, map) && !definite::removeOverlaps(*soup, snapshot, map))
            return false;
        SeamedMap guarded = map;
        definite::relaxWithoutOverlaps(soup, snapshot, guarded, fineSteps, job);
        if (!definite::coversItself(*soup, guarded))
            map = std::move(guarded);
        if ((options.lambda || map.distortion(*soup) > options.maxDistortion) &&
            definite::removeOverlaps(*soup, snapshot, relaxed) &&
            relaxed.distortion(*soup) < map.distortion(*soup))
            map = std::move(relaxed);
    }
    definite::equalizeDensity(*soup, snapshot, map);
    return true;
}

//! Puts a map exactly onto its pins. \returns the faults that are left
int settle(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const UnwrapOptions &options,
           SeamedMap &map)
{
    if (!snapshot.placesIslands())
        return 0;
    const auto graph = search::SeamGraph::build(soup, snapshot);
    return search::settleAtAnchors(graph, map, fineSteps, !options.allowOverlaps);
}

//! Maps the coarse version and carries the map to the fine mesh, where it may still flip and overlap.
//! \param coarseOptions with a share of the allowed distortion
std::optional<CarriedMap> carry(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                const UnwrapOptions &coarseOptions, int coarseTriangles,
                                const CoarseUnwrap &unwrapCoarse, const JobContext &job)
{
    const std::vector<bool> decided = decidedEdges(snapshot);
    multires::ProgressiveMesh mesh(*soup->mesh, keptEdges(snapshot, decided));
    const Decisions decisions = decisionsOf(snapshot, mesh, decided);
    const std::vector<double> weights = pointWeights(snapshot, mesh);
    std::vector<double> preferred =
        pointWeights(preference::SeamPreference().applied(snapshot, job.threads()), mesh);
    mesh.coarsen(coarseTriangles, job);
    if (job.stopped() || mesh.triangleCount() > leastReduction * soup->triangleCount())
        return std::nullopt;
    std::vector<int> triangles;
    const std::shared_ptr<const MeshData> coarse = mesh.extract(triangles);

    std::optional<CarriedMap> found =
        unwrapCoarse(coarseSnapshot(snapshot, coarse, mesh, triangles, decisions, weights), coarseOptions);
    if (!found)
        return std::nullopt;
    CarriedMap &carried = *found;

    multires::MapRefiner refiner(mesh, soup->scale);
    refiner.uv.assign(soup->mesh->soupCornerCount(), Vec2::Zero());
    refiner.cut.assign(soup->mesh->soupCornerCount(), 0);
    refiner.pointCost = std::move(preferred);
    refiner.mayStraighten = decisions.empty();
    // A map that nothing holds gets the area of the mesh.
    const double scale = snapshot.placesIslands() ? 1 / unitOf(*coarse, *soup->mesh)
                                                  : std::sqrt(std::numbers::pi / areaOf(carried.map));
    setCoarseMap(*coarse, carried.map, scale, triangles, mesh, refiner);
    refiner.refineTo(soup->triangleCount(), job);
    carried.map = fineMap(*soup, refiner);
    return found;
}

} // namespace

bool isLargeMesh(const MeshData &mesh)
{
    return mesh.triangleCount() > largeMesh;
}

bool suitsCoarseToFine(const Snapshot &snapshot)
{
    return isLargeMesh(*snapshot.mesh) && snapshot.settings.start != StartMode::ExistingUv;
}

std::optional<CarriedMap> mapByCoarse(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                      const UnwrapOptions &options, const CoarseUnwrap &unwrapCoarse,
                                      const JobContext &job, int coarseTriangles)
{
    std::optional<CarriedMap> best;
    for (const double share : coarseShares) {
        UnwrapOptions coarseOptions = options;
        coarseOptions.pack = false;
        coarseOptions.maxDistortion = 4 + share * (options.maxDistortion - 4);
        std::optional<CarriedMap> carried =
            carry(soup, snapshot, coarseOptions, coarseTriangles, unwrapCoarse, job);
        if (!carried || !makeUsable(soup, snapshot, options, carried->map, job))
            break;
        carried->anchorFaults = settle(soup, snapshot, options, carried->map);
        const double distortion = carried->map.distortion(*soup);
        if (!best || distortion < best->map.distortion(*soup))
            best = std::move(carried);
        if (options.lambda || distortion <= options.maxDistortion || job.stopped())
            break;
    }
    return best;
}

} // namespace autocuts::unwrap
