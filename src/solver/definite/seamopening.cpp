#include "solver/definite/seamopening.h"

#include "model/plain/chart.h"
#include "model/plain/polygonsides.h"
#include "solver/definite/seamgaps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::definite {

namespace {

//! A corner moves by at most this share of the height of each of its triangles. Chosen by hand.
constexpr double mostOfHeight = 0.1;

double meanSideLength(const MeshData &mesh, const UvTopology &topology, const UvMatrix &uv)
{
    double sum = 0;
    int count = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int start = mesh.faceStart[f], end = mesh.faceStart[f + 1];
        for (int c = start; c < end && topology.faceHasUv[f]; ++c) {
            sum += (uv.row(c + 1 < end ? c + 1 : start) - uv.row(c)).norm();
            ++count;
        }
    }
    return count > 0 ? sum / count : 0;
}

//! Marks the UV vertices, by their first corners, on the given sides whose partner lies nearer than
//! `distance`.
std::vector<bool> closedVertices(const MeshData &mesh, const UvTopology &topology,
                                 const std::vector<bool> &apart, const UvMatrix &uv, double distance)
{
    std::vector<bool> closed(mesh.cornerCount(), false);
    for (int e = 0; e < static_cast<int>(mesh.edgePairs.size()); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (pair.diagonal || !apart[sidePair(mesh, e).startCorner[0]])
            continue;
        for (const auto &[first, second] : pair.corner) {
            const int a = topology.cornerRoot[mesh.cornerOfSoup(first)];
            const int b = topology.cornerRoot[mesh.cornerOfSoup(second)];
            if (a != b && (uv.row(a) - uv.row(b)).norm() < distance)
                closed[a] = closed[b] = true;
        }
    }
    return closed;
}

//! Which way and how far a UV vertex may move.
struct Freedom
{
    Vec2 inward = Vec2::Zero(); //!< points into the middle of its fan of triangles, any length
    double height = std::numeric_limits<double>::infinity(); //!< least height of its triangles
    bool held = false;
};

//! The freedom of the marked UV vertices. The directions from a vertex into its fan of triangles, added up
//! over all angles, point along the middle of the fan, whether it is narrower or wider than half a turn.
std::vector<Freedom> freedomOf(const MeshData &mesh, const UvTopology &topology,
                               const std::vector<bool> &marked, const std::vector<bool> &held,
                               const UvMatrix &uv)
{
    std::vector<double> chartArea(topology.charts.count, 0);
    const auto doubleArea = [&](const std::array<int, 3> &t) {
        return cross2(uv.row(t[0]).transpose(), uv.row(t[1]).transpose(), uv.row(t[2]).transpose());
    };
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (const int chart = topology.charts.faceChart[mesh.triangleFace[t]]; chart >= 0)
            chartArea[chart] += doubleArea(mesh.triangles[t]);
    }
    std::vector<Freedom> result(mesh.cornerCount());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t], chart = topology.charts.faceChart[face];
        if (chart < 0)
            continue;
        const double side = chartArea[chart] < 0 ? -1 : 1, area = side * doubleArea(mesh.triangles[t]);
        for (int k = 0; k < 3; ++k) {
            const int root = topology.cornerRoot[mesh.triangles[t][k]];
            if (!marked[root])
                continue;
            Freedom &freedom = result[root];
            freedom.held = freedom.held || (!held.empty() && held[face]);
            const Vec2 p = uv.row(mesh.triangles[t][k]).transpose();
            const Vec2 a = uv.row(mesh.triangles[t][(k + 1) % 3]).transpose();
            const Vec2 b = uv.row(mesh.triangles[t][(k + 2) % 3]).transpose();
            if (!(area > 0))
                continue; // flipped or without area already
            const Vec2 from = (a - p).normalized(), to = (b - p).normalized();
            freedom.inward += side * Vec2(to.y() - from.y(), from.x() - to.x());
            freedom.height = std::min(freedom.height, area / (b - a).norm());
        }
    }
    return result;
}

} // namespace

void openSides(const MeshData &mesh, const std::vector<bool> &apart, const std::vector<bool> &held,
               UvMatrix &uv)
{
    const UvTopology topology = findUvTopology(mesh, uv, apart);
    const double half = 0.5 * seamGap(meanSideLength(mesh, topology, uv), topology.boxDiagonal());
    const std::vector<bool> closed = closedVertices(mesh, topology, apart, uv, half);
    const std::vector<Freedom> freedom = freedomOf(mesh, topology, closed, held, uv);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        const Freedom &own = freedom[topology.cornerRoot[c]];
        const double length = own.inward.norm();
        if (closed[topology.cornerRoot[c]] && !own.held && length > 0)
            uv.row(c) += (std::min(half, mostOfHeight * own.height) / length * own.inward).transpose();
    }
}

void openCuts(const Snapshot &snapshot, UvMatrix &uv)
{
    const std::vector<PairState> &state = snapshot.steering->pairState;
    std::vector<int> cuts;
    for (std::size_t pair = 0; pair + 1 < state.size(); pair += 2) {
        if (state[pair] == PairState::Cut && state[pair + 1] == PairState::Cut)
            cuts.push_back(static_cast<int>(pair / 2));
    }
    if (cuts.empty())
        return;
    const MeshData &mesh = *snapshot.mesh;
    std::vector<bool> pinned(mesh.faceCount(), false);
    for (const Pin &pin : snapshot.steering->pins)
        pinned[mesh.triangleFace[pin.soupCorner / 3]] =
            pinned[mesh.triangleFace[pin.soupCorner / 3]] || pin.hard;
    openSides(mesh, sidesOf(mesh, cuts), pinned, uv);
}

std::vector<bool> sidesOf(const MeshData &mesh, const std::vector<int> &edges)
{
    std::vector<bool> sides(mesh.cornerCount(), false);
    for (const int edge : edges) {
        for (const int corner : sidePair(mesh, edge).startCorner)
            sides[corner] = true;
    }
    return sides;
}

} // namespace autocuts::definite
