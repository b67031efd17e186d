#include "solver/unwrap/unmetsteering.h"

#include "model/plain/chart.h"
#include "model/plain/uvseams.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace autocuts::unwrap {

namespace {

//! How far, in texture space, a corner may be from where it has to be. Far below a texel.
constexpr double tolerance = 1e-6;

//! A part of an edge loop without a break in the map.
struct Stretch
{
    int chart, face;
    std::vector<int> edges; //!< edge pairs
    std::vector<Vec2> points;
};

//! Adds an edge, as one of its sides has it, to a stretch that it continues.
void addSide(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts, int edge, int side,
             std::vector<Stretch> &stretches)
{
    const EdgePair &pair = mesh.edgePairs[edge];
    const int face = mesh.triangleFace[pair.triangle[side]], chart = charts.faceChart[face];
    const Vec2 one = uv.row(mesh.cornerOfSoup(pair.corner[0][side])),
               other = uv.row(mesh.cornerOfSoup(pair.corner[1][side]));
    if (chart < 0)
        return;
    for (Stretch &stretch : stretches) {
        std::vector<Vec2> &points = stretch.points;
        if (stretch.chart != chart)
            continue;
        if (points.size() == 2 && points.back() != one && points.back() != other)
            std::reverse(points.begin(), points.end());
        const std::size_t last = points.size() - 1;
        if ((points[last] == one && points[last - 1] == other) ||
            (points[last] == other && points[last - 1] == one))
            return; // not cut: the other side was there
        if (points[last] != one && points[last] != other)
            continue;
        points.push_back(points[last] == one ? other : one);
        stretch.edges.push_back(edge);
        return;
    }
    stretches.push_back({chart, face, {edge}, {one, other}});
}

//! True when its points are not on one line.
bool isBent(const Stretch &stretch)
{
    constexpr double straight = 1e-3; // way off the line, as a share of the length; chosen by hand
    const Vec2 along = stretch.points.back() - stretch.points.front();
    double length = 0, off = 0;
    for (std::size_t i = 1; i < stretch.points.size(); ++i)
        length += (stretch.points[i] - stretch.points[i - 1]).norm();
    const Vec2 normal = Vec2(-along.y(), along.x()).normalized();
    for (const Vec2 &point : stretch.points)
        off = std::max(off, std::abs(normal.dot(point - stretch.points.front())));
    // A closed loop has no direction; it is not straight as long as it encloses anything.
    return along.norm() < 0.5 * length || off > straight * length;
}

bool isInScope(const Snapshot &snapshot, int face)
{
    return !snapshot.scope || snapshot.scope->faces[face];
}

} // namespace

std::vector<int> bentEdges(const Snapshot &snapshot, const UvMatrix &uv)
{
    if (snapshot.steering->straightLoops.empty())
        return {};
    const MeshData &mesh = *snapshot.mesh;
    const ChartMap charts = findCharts(mesh, uv);
    std::vector<bool> pinned(charts.count, false);
    for (const Pin &pin : snapshot.steering->pins) {
        if (const int chart = charts.faceChart[mesh.triangleFace[pin.soupCorner / 3]]; chart >= 0)
            pinned[chart] = true;
    }
    std::vector<int> bent;
    for (const std::vector<int> &loop : snapshot.steering->straightLoops) {
        std::vector<Stretch> stretches;
        for (const int edge : loop) {
            for (int side = 0; side < 2; ++side)
                addSide(mesh, uv, charts, edge, side, stretches);
        }
        for (const Stretch &stretch : stretches) {
            if (!pinned[stretch.chart] && isInScope(snapshot, stretch.face) && isBent(stretch))
                bent.insert(bent.end(), stretch.edges.begin(), stretch.edges.end());
        }
    }
    std::sort(bent.begin(), bent.end());
    bent.erase(std::unique(bent.begin(), bent.end()), bent.end());
    return bent;
}

UnmetSteering unmetSteering(const Snapshot &snapshot, const UvMatrix &uv)
{
    const MeshData &mesh = *snapshot.mesh;
    const Steering &steering = *snapshot.steering;
    const auto faceOf = [&](int soupCorner) { return mesh.triangleFace[soupCorner / 3]; };
    UnmetSteering unmet;
    for (const Pin &pin : steering.pins) {
        const int corner = mesh.cornerOfSoup(pin.soupCorner);
        const double distance = (Vec2(uv.row(corner)) - snapshot.uvScale * pin.target).norm();
        if (pin.hard && isInScope(snapshot, faceOf(pin.soupCorner)) && !(distance <= tolerance))
            unmet.pins.push_back(corner);
    }
    std::sort(unmet.pins.begin(), unmet.pins.end());
    unmet.pins.erase(std::unique(unmet.pins.begin(), unmet.pins.end()), unmet.pins.end());
    const bool only = snapshot.settings.seams == SeamMode::Only;
    const auto isCut = [&](std::size_t pair) {
        return !steering.pairState.empty() && steering.pairState[pair] == PairState::Cut;
    };
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto [a, b] = mesh.edgePairs[e].triangle;
        if ((!open[2 * e] && !open[2 * e + 1]) || !isInScope(snapshot, mesh.triangleFace[a]) ||
            !isInScope(snapshot, mesh.triangleFace[b]))
            continue;
        const bool given =
            isCut(2 * e) || isCut(2 * e + 1) || (!steering.givenSeams.empty() && steering.givenSeams[e]);
        if (snapshot.isJoined(e))
            unmet.joins.push_back(static_cast<int>(e));
        else if (only && !given)
            unmet.missingSeams.push_back(static_cast<int>(e));
    }
    for (std::size_t i = 0; i < steering.rectangles.size(); ++i) {
        const UvRectangle &box = steering.rectangles[i];
        const Eigen::AlignedBox2d place(Vec2(snapshot.uvScale * box.lower),
                                        Vec2(snapshot.uvScale * box.upper));
        const bool leaves = std::any_of(box.soupCorners.begin(), box.soupCorners.end(), [&](int corner) {
            return isInScope(snapshot, faceOf(corner)) &&
                   !(place.exteriorDistance(Vec2(uv.row(mesh.cornerOfSoup(corner)))) <= tolerance);
        });
        if (leaves)
            unmet.rectangles.push_back(static_cast<int>(i));
    }
    unmet.bent = bentEdges(snapshot, uv);
    return unmet;
}

} // namespace autocuts::unwrap
