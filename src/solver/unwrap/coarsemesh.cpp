#include "solver/unwrap/coarsemesh.h"

#include "solver/base/cornerat.h"
#include "solver/definite/definitemap.h"
#include "solver/multires/maprefiner.h"
#include "solver/preference/seampreference.h"
#include "solver/search/seamtrial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::unwrap {

namespace {

// Numbers in this file were chosen by hand.

//! The coarse mesh has at most this share of the triangles, else coarsening is not worth the effort.
constexpr double leastReduction = 0.6;
//! Nor may it have more than this multiple of the area: coarsening takes area away, unless it crumples parts
//! that are thinner than its triangles. Measured: .92 to 1.0006 on 16 models and on noisy shapes, 1.13 on a
//! generated one of tubes and sheets.
constexpr double mostArea = 1.05;
//! Energy of a triangle from which refining has found no place for it. It becomes a chart of its own: it
//! would stop the steps of all others.
constexpr double lostEnergy = 1e6;

using PointPair = std::pair<int, int>;
using Decisions = std::map<PointPair, std::array<std::pair<int, PairState>, 2>>;

PointPair endsOf(const multires::ProgressiveMesh &mesh, int side)
{
    return std::minmax(mesh.point(side), mesh.point(multires::ProgressiveMesh::next(side)));
}

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

//! Makes charts of single triangles that have hardly any area in the map. Those of larger polygons, and those
//! with an edge that the user joined, stay.
void isolateLost(const Soup &soup, const Snapshot &snapshot, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<char> lost(soup.triangleCount(), 0);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        const double *at = &map.x[6 * static_cast<std::size_t>(t)];
        lost[t] = mesh.trianglesOf(mesh.triangleFace[t]).size() == 1 &&
                  !(search::triangleEnergy(at, soup.basis[t]) < lostEnergy);
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        if (snapshot.isJoined(e)) {
            for (const int t : mesh.edgePairs[e].triangle)
                lost[t] = 0;
        }
    }
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        if (lost[c / 3])
            cornerAt(map.x, c) = cornerAt(soup.restShape[c / 3], c % 3);
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        const auto [one, other] = mesh.edgePairs[e].triangle;
        map.cut[e] = map.cut[e] || lost[one] || lost[other];
    }
}

//! The refined map as coordinates and cut flags of the fine mesh.
SeamedMap fineMap(const Soup &soup, const Snapshot &snapshot, const multires::MapRefiner &refiner)
{
    SeamedMap map;
    map.x.resize(soup.coordinateCount());
    for (std::size_t c = 0; c < refiner.uv.size(); ++c)
        cornerAt(map.x, static_cast<int>(c)) = refiner.uv[c];
    const MeshData &mesh = *soup.mesh;
    map.cut.resize(mesh.edgePairs.size());
    for (std::size_t e = 0; e < map.cut.size(); ++e)
        map.cut[e] = refiner.cut[3 * mesh.edgePairs[e].triangle[0] + mesh.edgePairs[e].side(0)] != 0;
    isolateLost(soup, snapshot, map);
    leaveDiagonals(soup, map);
    return map;
}

} // namespace

CoarseMesh::CoarseMesh(std::shared_ptr<const Soup> soup, const Snapshot &snapshot, int triangles,
                       const JobContext &job)
    : mSoup(std::move(soup)), mSnapshot(snapshot), mKept(decidedEdges(snapshot)),
      mMesh(*mSoup->mesh, keptEdges(snapshot, mKept)), mDecisions(decisionsOf(snapshot, mMesh, mKept)),
      mWeights(pointWeights(snapshot, mMesh)),
      mPreferred(pointWeights(preference::SeamPreference().applied(snapshot, job.threads()), mMesh))
{
    mMesh.coarsen(triangles, job);
    mCoarse = mMesh.extract(mTriangles);
}

bool CoarseMesh::isWorthIt() const
{
    return mMesh.triangleCount() <= leastReduction * mSoup->triangleCount() &&
           mCoarse->area <= mostArea * mSoup->mesh->area;
}

Snapshot CoarseMesh::snapshot() const
{
    return coarseSnapshot(mSnapshot, mCoarse, mMesh, mTriangles, mDecisions, mWeights);
}

std::optional<SeamedMap> CoarseMesh::carried(const SeamedMap &coarse, const JobContext &job) const
{
    multires::ProgressiveMesh mesh = mMesh;
    multires::MapRefiner refiner(mesh, mSoup->scale);
    refiner.uv.assign(mSoup->mesh->soupCornerCount(), Vec2::Zero());
    refiner.cut.assign(mSoup->mesh->soupCornerCount(), 0);
    refiner.pointCost = mPreferred;
    refiner.mayStraighten = mDecisions.empty();
    // A map that nothing holds gets the area that the triangles are to have.
    double target = 0;
    for (int t = 0; t < mSoup->triangleCount(); ++t)
        target += mSoup->mesh->targetArea(t);
    const double scale = mSnapshot.placesIslands()
                             ? 1 / unitOf(*mCoarse, *mSoup->mesh)
                             : std::sqrt(std::numbers::pi * (target / mSoup->mesh->area) / areaOf(coarse));
    setCoarseMap(*mCoarse, coarse, scale, mTriangles, mesh, refiner);
    refiner.refineTo(mSoup->triangleCount(), job);
    if (job.stopped())
        return std::nullopt;
    SeamedMap map = fineMap(*mSoup, mSnapshot, refiner);
    if (!map.validate(*mSoup).empty())
        map = definite::stitchTo(mSoup, mSnapshot, map.cut, map.x, job);
    return job.stopped() ? std::nullopt : std::optional(std::move(map));
}

} // namespace autocuts::unwrap
