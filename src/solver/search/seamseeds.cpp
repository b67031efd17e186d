#include "solver/search/seamseeds.h"

#include "solver/base/constant.h"
#include "solver/base/cornerat.h"
#include "solver/base/random.h"
#include "solver/search/chartclusters.h"
#include "solver/search/seamchains.h"
#include "solver/search/shortestpaths.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace autocuts::search {

namespace {

//! Amplitudes of the noise on edge costs, natural logarithm: of each of six waves, and of single edges.
AUTOCUTS_CONSTANT(double, waveNoise, 0.15);
AUTOCUTS_CONSTANT(double, edgeNoise, 0.2);

//! Edge costs times random factors and smooth noise (a sum of six waves), so that every seed finds other
//! paths. Mirror images get equal costs.
std::vector<double> noisyCosts(const SeamGraph &graph, Random &random)
{
    const MeshData &mesh = *graph.soup->mesh;
    std::array<Vec3, 6> wave;
    std::array<double, 6> phase;
    const double wavelength = graph.soup->scale;
    for (int i = 0; i < 6; ++i) {
        wave[i] =
            Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) * (6 * wavelength);
        phase[i] = random.uniform(0, 6.283185307179586);
    }
    std::vector<double> cost(graph.cost.size());
    for (std::size_t e = 0; e < cost.size(); ++e) {
        const Vec3 p = mesh.cornerPosition(mesh.cornerOfSoup(mesh.edgePairs[e].corner[0][0]));
        double noise = 0;
        for (int i = 0; i < 6; ++i)
            noise += std::sin(wave[i].dot(p) + phase[i]);
        cost[e] = graph.cost[e] * std::exp(waveNoise * noise + edgeNoise * random.uniform(-1, 1)) + 1e-9;
    }
    for (std::size_t e = 0; e < graph.mirror.size(); ++e) {
        if (graph.mirror[e] >= 0)
            cost[e] = cost[std::min(static_cast<int>(e), graph.mirror[e])];
    }
    return cost;
}

//! True when a chart lies on both sides of some cut edge.
bool isCutInside(const SeamGraph &graph, const std::vector<int> &chart, int c, const CutFlags &cut)
{
    const std::vector<EdgePair> &pairs = graph.soup->mesh->edgePairs;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (cut[e] && chart[pairs[e].triangle[0]] == c && chart[pairs[e].triangle[1]] == c)
            return true;
    }
    return false;
}

//! Opens a closed chart symmetrically: by a path in the plane of symmetry, or by a path from a vertex on the
//! plane and its mirror image. \returns the number of edges of the path without its image; 0 when no vertex
//! of the chart lies on the plane
int openAcrossPlane(const SeamGraph &graph, ShortestPaths &paths, const std::vector<int> &points,
                    Random &random, CutFlags &cut)
{
    std::vector<int> onPlane;
    std::copy_if(points.begin(), points.end(), std::back_inserter(onPlane),
                 [&](int v) { return graph.onPlane[v]; });
    if (onPlane.empty())
        return 0;
    const int any = onPlane[random.below(static_cast<int>(onPlane.size()))];
    const bool along = random.uniform() < 0.5;
    paths.run({any}, Way::AlongPlane);
    const int start = paths.farthest();
    int edges = 0;
    if (along) {
        paths.run({start}, Way::AlongPlane);
        edges = paths.cutPath(paths.farthest(), cut);
    }
    if (edges < 2) {
        paths.run({any}, Way::OneSide);
        edges = paths.cutPath(paths.farthest(), cut);
    }
    graph.makeSymmetric(cut);
    return edges;
}

//! Opens closed charts along a path and cuts charts with handles to disks.
void openCharts(const SeamGraph &graph, const std::vector<double> &cost, Random &random, CutFlags &cut)
{
    const MeshData &mesh = *graph.soup->mesh;
    const CutMesh state(mesh, cut);
    // Euler characteristic and number of loops of each chart.
    std::vector<int> euler(state.chartCount, 0), loops(state.chartCount, 0), first(state.chartCount, -1);
    std::vector<bool> seen(state.uvVertexCount, false);
    for (int side = 0; side < mesh.soupCornerCount(); ++side) {
        const int c = state.chart[side / 3];
        if (first[c] < 0)
            first[c] = side;
        if (side % 3 == 0)
            ++euler[c];
        if (state.neighbour[side] < side) // each edge once
            --euler[c];
        if (!seen[state.uvVertex[side]]) {
            seen[state.uvVertex[side]] = true;
            ++euler[c];
        }
    }
    for (const std::vector<int> &loop : state.boundaryLoops())
        ++loops[state.chart[loop.front() / 3]];
    std::vector<bool> handles(state.chartCount, false);
    bool anyHandles = false;
    for (int c = 0; c < state.chartCount; ++c)
        anyHandles |= handles[c] = euler[c] + loops[c] < 2;
    if (anyHandles) {
        const CutFlags disks = cutToDisks(mesh, cut);
        for (std::size_t e = 0; e < cut.size(); ++e) {
            if (handles[state.chart[mesh.edgePairs[e].triangle[0]]])
                cut[e] = disks[e];
        }
    }
    graph.makeSymmetric(cut);
    ShortestPaths paths(graph, cost);
    std::optional<CutFlags> disks;
    for (int c = 0; c < state.chartCount; ++c) {
        if (loops[c] > 0 || handles[c] || (graph.isMirrored() && isCutInside(graph, state.chart, c, cut)))
            continue;
        paths.run({graph.vertex[first[c]]});
        const std::vector<int> points = paths.reached();
        if (graph.isMirrored() && openAcrossPlane(graph, paths, points, random, cut) > 0)
            continue;
        // From a random vertex of the chart, so that the seeds differ.
        paths.run({points[random.below(static_cast<int>(points.size()))]});
        paths.run({paths.farthest()});
        if (paths.cutPath(paths.farthest(), cut) < 2) {
            if (!disks || graph.isMirrored())
                disks = cutToDisks(mesh, cut);
            for (std::size_t e = 0; e < cut.size(); ++e) {
                if (state.chart[mesh.edgePairs[e].triangle[0]] == c)
                    cut[e] = (*disks)[e];
            }
        }
        graph.makeSymmetric(cut);
    }
}

//! The boundary loops of the charts of some cuts.
struct ChartLoops
{
    ChartLoops(const SeamGraph &graph, const CutFlags &cut)
        : state(*graph.soup->mesh, cut), loops(state.boundaryLoops())
    {}

    int chartOf(std::size_t loop) const { return state.chart[loops[loop].front() / 3]; }

    const CutMesh state;
    const std::vector<std::vector<int>> loops; //!< sides, see CutMesh::boundaryLoops()
};

//! What becomes of a loop.
enum class LoopRole {
    Joined, //!< paths may end there
    Joins,  //!< a path begins there
    Stays
};

//! Cuts a path within each chart from every loop that joins to the nearest one that is joined already.
void joinLoops(const SeamGraph &graph, const std::vector<double> &cost, const ChartLoops &of,
               const std::vector<LoopRole> &role, CutFlags &cut)
{
    const std::vector<EdgePair> &pairs = graph.soup->mesh->edgePairs;
    std::vector<std::vector<std::size_t>> ofChart(of.state.chartCount);
    for (std::size_t i = 0; i < of.loops.size(); ++i)
        ofChart[of.chartOf(i)].push_back(i);
    ShortestPaths paths(graph, cost);
    std::vector<int> joinedIn(graph.vertexCount, -1); // the last chart on a joined loop of which a vertex is
    for (int chart = 0; chart < of.state.chartCount; ++chart) {
        const auto join = [&](std::size_t loop) {
            for (const int side : of.loops[loop])
                joinedIn[graph.vertex[side]] = chart;
        };
        for (const std::size_t i : ofChart[chart]) {
            if (role[i] == LoopRole::Joined)
                join(i);
        }
        for (const std::size_t i : ofChart[chart]) {
            if (role[i] != LoopRole::Joins)
                continue;
            // The path may start at any vertex of the loop.
            std::vector<int> from;
            for (const int side : of.loops[i])
                from.push_back(graph.vertex[side]);
            const int nearest = paths.run(
                from, Way::Any,
                [&](int e, int) {
                    return of.state.chart[pairs[e].triangle[0]] == chart ||
                           of.state.chart[pairs[e].triangle[1]] == chart;
                },
                [&](int v) { return joinedIn[v] == chart; });
            if (nearest >= 0)
                paths.cutPath(nearest, cut);
            join(i);
        }
    }
}

enum class Loops {
    All,
    Slits //!< those without a border of the mesh
};

//! Joins the boundary loops of each chart to the longest one (by number of edges), and slits to borders.
void joinLoops(const SeamGraph &graph, const std::vector<double> &cost, Loops which, CutFlags &cut)
{
    const ChartLoops of(graph, cut);
    std::vector<int> longest(of.state.chartCount, -1);
    for (std::size_t i = 0; i < of.loops.size(); ++i) {
        int &l = longest[of.chartOf(i)];
        if (l < 0 || of.loops[i].size() > of.loops[l].size())
            l = static_cast<int>(i);
    }
    const auto isBorder = [&](int side) { return graph.across[side] < 0; };
    std::vector<LoopRole> role;
    for (std::size_t i = 0; i < of.loops.size(); ++i) {
        const bool isJoined = longest[of.chartOf(i)] == static_cast<int>(i) ||
                              (which == Loops::Slits && std::ranges::any_of(of.loops[i], isBorder));
        role.push_back(isJoined ? LoopRole::Joined : LoopRole::Joins);
    }
    joinLoops(graph, cost, of, role, cut);
}

//! By how much the boundary of a chart turns along a loop, on the surface: 2 pi around a disk, 0 at the end
//! of a tube, -2 pi around a hole in a plane.
std::vector<double> turningOf(const SeamGraph &graph, const CutMesh &state,
                              const std::vector<std::vector<int>> &loops)
{
    const Soup &soup = *graph.soup;
    std::vector<double> angle(state.uvVertexCount, 0);
    for (int c = 0; c < static_cast<int>(state.uvVertex.size()); ++c) {
        const auto &shape = soup.restShape[c / 3];
        const Vec2 at = cornerAt(shape, c % 3);
        const Vec2 a = cornerAt(shape, (c + 1) % 3) - at, b = cornerAt(shape, (c + 2) % 3) - at;
        angle[state.uvVertex[c]] += std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
    }
    std::vector<double> turning;
    for (const std::vector<int> &loop : loops) {
        double sum = 0;
        for (const int side : loop)
            sum += std::numbers::pi - angle[state.uvVertex[side]];
        turning.push_back(sum);
    }
    return turning;
}

//! Loops that turn less than this are holes.
constexpr double holeTurning = -std::numbers::pi;

//! Cuts tubes open: paths within a chart from each loop that is no hole to those that turn most.
void openTubes(const SeamGraph &graph, const std::vector<double> &cost, CutFlags &cut)
{
    const ChartLoops of(graph, cut);
    const std::vector<double> turning = turningOf(graph, of.state, of.loops);
    std::vector<int> outer(of.state.chartCount, -1);
    for (std::size_t i = 0; i < of.loops.size(); ++i) {
        int &l = outer[of.chartOf(i)];
        if (l < 0 || turning[i] > turning[l])
            l = static_cast<int>(i);
    }
    std::vector<LoopRole> role;
    for (std::size_t i = 0; i < of.loops.size(); ++i) {
        if (outer[of.chartOf(i)] == static_cast<int>(i))
            role.push_back(LoopRole::Joined);
        else
            role.push_back(turning[i] < holeTurning ? LoopRole::Stays : LoopRole::Joins);
    }
    joinLoops(graph, cost, of, role, cut);
}

//! Cuts edges between which Tutte's embedding would be flat: those that join the same two vertices of a
//! chart, and one more at a slit of one edge.
void cutParallelEdges(const SeamGraph &graph, CutFlags &cut)
{
    const MeshData &mesh = *graph.soup->mesh;
    for (bool again = true; again;) {
        again = false;
        const auto open = [&](int side) {
            const int e = graph.edgeOf[side];
            if (e < 0 || cut[e] || graph.rule[e] == SeamGraph::Rule::NeverCut)
                return false;
            return again = cut[e] = true;
        };
        const CutMesh state(mesh, cut);
        std::vector<std::tuple<int, int, int>> edges; // the vertices at the ends, then a side
        for (int side = 0; side < mesh.soupCornerCount(); ++side) {
            if (state.neighbour[side] > side || state.neighbour[side] < 0) {
                const auto [a, b] =
                    std::minmax(state.uvVertex[side], state.uvVertex[side / 3 * 3 + (side + 1) % 3]);
                edges.emplace_back(a, b, side);
            }
        }
        std::sort(edges.begin(), edges.end());
        const auto parallel = [&](std::size_t i, std::size_t j) {
            return j < edges.size() && std::get<0>(edges[i]) == std::get<0>(edges[j]) &&
                   std::get<1>(edges[i]) == std::get<1>(edges[j]);
        };
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (parallel(i, i + 1) || (i > 0 && parallel(i - 1, i)))
                open(std::get<2>(edges[i]));
        }
        for (const std::vector<int> &loop : state.boundaryLoops()) {
            const int side = loop.front(), next = side / 3 * 3 + (side + 1) % 3;
            if (loop.size() == 2 && !open(next))
                open(side / 3 * 3 + (side + 2) % 3);
        }
    }
}

//! Cuts the mirror images of all cuts. Where the mesh is not quite symmetric, some edges have none: what is
//! left of an image is joined, since pieces of a path within a chart would be points in its embedding.
void mirrorCuts(const SeamGraph &graph, const std::vector<double> &cost, CutFlags &cut)
{
    if (!graph.isMirrored())
        return;
    graph.makeSymmetric(cut);
    joinLoops(graph, cost, Loops::Slits, cut);
}

//! Per vertex of the uncut surface: logarithm of the area of its triangles in 3D over that in the embedding.
std::vector<double> shrinkage(const SeamGraph &graph, const std::vector<double> &x)
{
    const Soup &soup = *graph.soup;
    std::vector<double> area(graph.vertexCount, 0), mapped(graph.vertexCount, 0);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        const double share = std::max(jacobianDeterminant(soup, x.data(), t), 0.0) * soup.weight[t];
        for (int k = 0; k < 3; ++k) {
            area[graph.vertex[3 * t + k]] += soup.weight[t];
            mapped[graph.vertex[3 * t + k]] += share;
        }
    }
    for (int v = 0; v < graph.vertexCount; ++v)
        area[v] = std::log(area[v] / std::max(mapped[v], 1e-300));
    return area;
}

//! Cuts the shortest path from a vertex to the nearest seam or border. On a mirrored mesh it does not cross
//! the plane of symmetry if that can be avoided, because it would meet its own image there.
//! \returns false when there is no path
bool joinToSeam(const SeamGraph &graph, ShortestPaths &paths, int v, const std::vector<bool> &onSeam,
                CutFlags &cut)
{
    std::vector<Way> ways{Way::Any};
    if (graph.isMirrored())
        ways = {graph.onPlane[v] ? Way::AlongPlane : Way::OneSide, Way::Any};
    for (const Way way : ways) {
        const int nearest = paths.run(
            {v}, way, [](int, int) { return true; }, [&](int w) -> bool { return onSeam[w]; });
        if (nearest >= 0) {
            paths.cutPath(nearest, cut);
            return true;
        }
    }
    return false;
}

} // namespace

std::vector<char> fewCuts(const SeamGraph &graph, const SeedOptions &options)
{
    const MeshData &mesh = *graph.soup->mesh;
    Random random(options.seed * 7919 + 1);
    const std::vector<double> cost = noisyCosts(graph, random);
    CutFlags cut(mesh.edgePairs.size());
    for (std::size_t e = 0; e < cut.size(); ++e)
        cut[e] = graph.rule[e] == SeamGraph::Rule::AlwaysCut;
    if (!options.mostSpread.empty())
        cut = clusterSeams(graph, options.mostSpread);
    openCharts(graph, cost, random, cut);
    if (!options.mostSpread.empty()) {
        openTubes(graph, cost, cut);
        cutParallelEdges(graph, cut);
    }
    if (options.joinBorders)
        joinLoops(graph, cost, Loops::All, cut);
    mirrorCuts(graph, cost, cut);

    ShortestPaths paths(graph, cost);
    const auto stopped = [&] { return options.job.stopped(); };
    for (int added = 0; added < options.paths && !stopped(); ++added) {
        const CutMesh state(mesh, cut);
        SeamedMap map{cut, tutteEmbedding(*graph.soup, state)};
        if (options.embedded)
            options.embedded(map);
        const std::vector<double> shrunk = shrinkage(graph, map.x);
        std::vector<bool> onSeam = graph.border;
        for (std::size_t e = 0; e < cut.size(); ++e) {
            if (cut[e])
                onSeam[graph.ends[e][0]] = onSeam[graph.ends[e][1]] = true;
        }
        std::vector<int> worst(state.chartCount, -1);
        for (int c = 0; c < mesh.soupCornerCount(); ++c) {
            int &w = worst[state.chart[c / 3]];
            const int v = graph.vertex[c];
            if (!onSeam[v] && shrunk[v] > options.shrinkage && (w < 0 || shrunk[v] > shrunk[w]))
                w = v;
        }
        bool any = false;
        for (const int v : worst) {
            if (v < 0)
                continue;
            any |= joinToSeam(graph, paths, v, onSeam, cut);
        }
        mirrorCuts(graph, cost, cut);
        if (!any)
            break;
    }
    return {cut.begin(), cut.end()};
}

} // namespace autocuts::search
