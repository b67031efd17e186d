#include "solver/definite/ripping.h"

#include "model/plain/chart.h"
#include "model/plain/polygonsides.h"
#include "model/plain/uvseams.h"
#include "solver/definite/seamopening.h"
#include "solver/packing/islandgeometry.h"
#include "solver/packing/movingaside.h"

#include <algorithm>
#include <map>

namespace autocuts::definite {

namespace {

//! A rip into more parts than this leaves all of them in place, with small gaps. Chosen by hand: each part
//! that moves takes some milliseconds.
constexpr int mostMovedParts = 64;

//! A part of an island that was split.
struct Part
{
    int chart = 0;
    int pins = 0;    //!< soup corners that are pinned hard
    double area = 0; //!< in the map, twice
};

//! The parts of each island that was split, the one that stays first.
std::vector<std::vector<Part>> splitIslands(const Snapshot &snapshot, const ChartMap &before,
                                            const ChartMap &after)
{
    const MeshData &mesh = *snapshot.mesh;
    std::vector<Part> parts(after.count);
    std::vector<int> island(after.count, -1);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t], chart = after.faceChart[face];
        if (chart < 0)
            continue;
        const auto &c = mesh.triangles[t];
        const UvMatrix &uv = *snapshot.uv;
        parts[chart].area +=
            std::abs(cross2(uv.row(c[0]).transpose(), uv.row(c[1]).transpose(), uv.row(c[2]).transpose()));
        island[chart] = before.faceChart[face];
    }
    for (const Pin &pin : snapshot.steering->pins) {
        const int chart = after.faceChart[mesh.triangleFace[pin.soupCorner / 3]];
        if (chart >= 0 && pin.hard)
            ++parts[chart].pins;
    }
    std::map<int, std::vector<Part>> byIsland;
    for (int chart = 0; chart < after.count; ++chart) {
        parts[chart].chart = chart;
        byIsland[island[chart]].push_back(parts[chart]);
    }
    std::vector<std::vector<Part>> result;
    for (auto &[number, own] : byIsland) {
        if (own.size() < 2)
            continue;
        std::stable_sort(own.begin(), own.end(), [](const Part &a, const Part &b) {
            return a.pins != b.pins ? a.pins > b.pins : a.area > b.area;
        });
        result.push_back(std::move(own));
    }
    return result;
}

//! For each chart the direction away from its ripped sides, into the chart; any length.
std::vector<Vec2> inwardDirections(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts,
                                   const std::vector<bool> &ripped)
{
    std::vector<double> area(charts.count, 0);
    std::vector<Vec2> sum(charts.count, Vec2::Zero());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int chart = charts.faceChart[f];
        const int start = mesh.faceStart[f], end = mesh.faceStart[f + 1];
        for (int c = start; c < end && chart >= 0; ++c) {
            const Vec2 from = uv.row(c).transpose(), to = uv.row(c + 1 < end ? c + 1 : start).transpose();
            area[chart] += cross2(uv.row(start).transpose(), from, to);
            if (ripped[c])
                sum[chart] += Vec2(from.y() - to.y(), to.x() - from.x());
        }
    }
    for (int chart = 0; chart < charts.count; ++chart)
        sum[chart] *= area[chart] < 0 ? -1 : 1;
    return sum;
}

void translate(const MeshData &mesh, const ChartMap &charts, int chart, const Vec2 &way, UvMatrix &uv)
{
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (charts.faceChart[f] != chart)
            continue;
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            uv.row(c) += way.transpose();
    }
}

//! Moves the parts of split islands aside where there is room.
void moveParts(const Snapshot &snapshot, const UvTopology &before, const std::vector<bool> &ripped,
               double gutter, UvMatrix &uv, const JobContext &job)
{
    const MeshData &mesh = *snapshot.mesh;
    const ChartMap charts = findUvTopology(mesh, uv, ripped).charts;
    const int moved = charts.count - before.charts.count;
    if (moved == 0 || moved > mostMovedParts)
        return;
    const std::vector<Vec2> directions = inwardDirections(mesh, uv, charts, ripped);
    packing::AsideMover mover(packing::makePackIslands(mesh, uv, charts), gutter, snapshot.tileHeight);
    int done = 0;
    for (const std::vector<Part> &parts : splitIslands(snapshot, before.charts, charts)) {
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const int chart = parts[i].chart;
            if (const auto way = mover.moveAside(chart, directions[chart], job))
                translate(mesh, charts, chart, *way, uv);
            job.report(double(++done) / moved);
        }
    }
}

} // namespace

RippedMap ripEdges(const Snapshot &snapshot, const std::vector<int> &edges, double gutter,
                   const JobContext &job)
{
    const MeshData &mesh = *snapshot.mesh;
    RippedMap result;
    result.uv = *snapshot.uv;
    const UvTopology before = findUvTopology(mesh, result.uv);
    std::vector<bool> locked;
    for (const std::vector<int> &faces : before.charts.faces())
        locked.push_back(!snapshot.steering->faceFlags.empty() &&
                         flagsOf(snapshot.steering->faceFlags, faces).locked != 0);
    for (const int edge : edges) {
        if (edge >= static_cast<int>(mesh.edgePairs.size()) || mesh.edgePairs[edge].diagonal)
            continue;
        const auto isLocked = [&](int triangle) {
            const int chart = before.charts.faceChart[mesh.triangleFace[triangle]];
            return chart >= 0 && locked[chart];
        };
        const auto [first, second] = mesh.edgePairs[edge].triangle;
        if (isLocked(first) || isLocked(second))
            ++result.locked;
        else
            result.edges.push_back(edge);
    }
    const std::vector<bool> openBefore = openCornerPairs(mesh, result.uv);
    for (const int edge : result.edges)
        result.wereOpen += openBefore[2 * edge] || openBefore[2 * edge + 1];
    const std::vector<bool> ripped = sidesOf(mesh, result.edges);
    moveParts(snapshot, before, ripped, gutter, result.uv, job);
    openSides(mesh, ripped, {}, result.uv);
    const std::vector<bool> open = openCornerPairs(mesh, result.uv);
    for (const int edge : result.edges)
        result.closed += !open[2 * edge] && !open[2 * edge + 1];
    result.newIslands = findCharts(mesh, result.uv).count - before.charts.count;
    return result;
}

} // namespace autocuts::definite
