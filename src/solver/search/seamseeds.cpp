#include "solver/search/seamseeds.h"

#include "solver/base/random.h"
#include "solver/search/seamchains.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace autocuts::search {

namespace {

//! Where a path may run on a mirrored mesh: anywhere, on one side of the plane of symmetry (only its ends may
//! lie on the plane), or within the plane.
enum class Way { Any, OneSide, AlongPlane };

//! True when a path that has reached vertex v may continue along edge e.
bool mayTake(const SeamGraph &graph, Way way, int e, int v, bool isStart)
{
    if (graph.rule[e] == SeamGraph::Rule::NeverCut)
        return false;
    if (way == Way::Any)
        return true;
    const bool onPlane = graph.onPlane[graph.ends[e][0]] && graph.onPlane[graph.ends[e][1]];
    if (way == Way::AlongPlane)
        return onPlane;
    return (isStart || !graph.onPlane[v]) && (onPlane || graph.mirror[e] != e);
}

//! Distances from the nearest of some vertices, along edges not joined by the user; -1: not reachable.
//! \param via receives per vertex the last edge of its path, -1 without one
std::vector<double> distances(const SeamGraph &graph, const std::vector<double> &cost,
                              const std::vector<int> &from, std::vector<int> &via, Way way = Way::Any)
{
    std::vector<double> distance(graph.vertexCount, -1);
    via.assign(graph.vertexCount, -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int v : from) {
        distance[v] = 0;
        queue.emplace(0, v);
    }
    while (!queue.empty()) {
        const auto [d, v] = queue.top();
        queue.pop();
        if (d > distance[v])
            continue;
        for (const int e : graph.edgesAt(v)) {
            if (!mayTake(graph, way, e, v, d == 0))
                continue;
            const int w = graph.farEnd(e, v);
            const double there = d + cost[e];
            if (distance[w] < 0 || there < distance[w]) {
                distance[w] = there;
                via[w] = e;
                queue.emplace(there, w);
            }
        }
    }
    return distance;
}

//! Edge costs times random factors and smooth noise (a sum of six waves), so that every seed finds other
//! paths. Mirror images get equal costs. Amplitudes 0.15 and 0.2 were chosen by hand; their effect has not
//! been measured.
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
        cost[e] = graph.cost[e] * std::exp(0.15 * noise + 0.2 * random.uniform(-1, 1)) + 1e-9;
    }
    for (std::size_t e = 0; e < graph.mirror.size(); ++e) {
        if (graph.mirror[e] >= 0)
            cost[e] = cost[std::min(static_cast<int>(e), graph.mirror[e])];
    }
    return cost;
}

//! The vertex with the largest distance.
int farthest(const std::vector<double> &distance)
{
    return static_cast<int>(std::max_element(distance.begin(), distance.end()) - distance.begin());
}

//! Cuts the path that ends at v. \returns its number of edges
int cutPath(const SeamGraph &graph, const std::vector<int> &via, int v, CutFlags &cut)
{
    int edges = 0;
    for (; via[v] >= 0; v = graph.farEnd(via[v], v), ++edges)
        cut[via[v]] = true;
    return edges;
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
int openAcrossPlane(const SeamGraph &graph, const std::vector<double> &cost, const std::vector<int> &points,
                    Random &random, CutFlags &cut)
{
    std::vector<int> onPlane;
    std::copy_if(points.begin(), points.end(), std::back_inserter(onPlane),
                 [&](int v) { return graph.onPlane[v]; });
    if (onPlane.empty())
        return 0;
    std::vector<int> via;
    const int any = onPlane[random.below(static_cast<int>(onPlane.size()))];
    const bool along = random.uniform() < 0.5;
    const int start = farthest(distances(graph, cost, {any}, via, Way::AlongPlane));
    int edges = 0;
    if (along)
        edges = cutPath(graph, via, farthest(distances(graph, cost, {start}, via, Way::AlongPlane)), cut);
    if (edges < 2)
        edges = cutPath(graph, via, farthest(distances(graph, cost, {any}, via, Way::OneSide)), cut);
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
    for (int c = 0; c < state.chartCount; ++c) {
        if (loops[c] > 0 || handles[c] || (graph.isMirrored() && isCutInside(graph, state.chart, c, cut)))
            continue;
        std::vector<int> via;
        int start = graph.vertex[first[c]];
        const std::vector<double> around = distances(graph, cost, {start}, via);
        // A random vertex of the chart, so that the seeds differ.
        std::vector<int> points;
        for (int v = 0; v < graph.vertexCount; ++v) {
            if (around[v] >= 0)
                points.push_back(v);
        }
        if (graph.isMirrored() && openAcrossPlane(graph, cost, points, random, cut) > 0)
            continue;
        start =
            farthest(distances(graph, cost, {points[random.below(static_cast<int>(points.size()))]}, via));
        if (cutPath(graph, via, farthest(distances(graph, cost, {start}, via)), cut) < 2) {
            const CutFlags disks = cutToDisks(mesh, cut);
            for (std::size_t e = 0; e < cut.size(); ++e) {
                if (state.chart[mesh.edgePairs[e].triangle[0]] == c)
                    cut[e] = disks[e];
            }
        }
        graph.makeSymmetric(cut);
    }
}

enum class Loops {
    All,
    Slits //!< those without a border of the mesh
};

//! Cuts a path from boundary loops of a chart to the nearest loop that is already joined to the longest one
//! (by number of edges).
void joinLoops(const SeamGraph &graph, const std::vector<double> &cost, Loops which, CutFlags &cut)
{
    const MeshData &mesh = *graph.soup->mesh;
    const CutMesh state(mesh, cut);
    std::vector<int> loopOf(graph.vertexCount, -1);
    const std::vector<std::vector<int>> loops = state.boundaryLoops();
    std::vector<int> longest(state.chartCount, -1);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        int &l = longest[state.chart[loops[i].front() / 3]];
        if (l < 0 || loops[i].size() > loops[l].size())
            l = static_cast<int>(i);
        for (const int side : loops[i])
            loopOf[graph.vertex[side]] = static_cast<int>(i);
    }
    std::vector<bool> joined(loops.size(), false);
    for (int c = 0; c < state.chartCount; ++c) {
        if (longest[c] >= 0)
            joined[longest[c]] = true;
    }
    const auto isBorder = [&](int side) { return graph.across[side] < 0; };
    for (std::size_t i = 0; i < loops.size() && which == Loops::Slits; ++i)
        joined[i] = joined[i] || std::any_of(loops[i].begin(), loops[i].end(), isBorder);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (joined[i])
            continue;
        // The path may start at any vertex of the loop.
        std::vector<int> from;
        for (const int side : loops[i])
            from.push_back(graph.vertex[side]);
        std::vector<int> via;
        const std::vector<double> distance = distances(graph, cost, from, via);
        int nearest = -1;
        for (int v = 0; v < graph.vertexCount; ++v) {
            if (loopOf[v] >= 0 && joined[loopOf[v]] && distance[v] >= 0 &&
                (nearest < 0 || distance[v] < distance[nearest]))
                nearest = v;
        }
        joined[i] = true;
        if (nearest >= 0)
            cutPath(graph, via, nearest, cut);
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
bool joinToSeam(const SeamGraph &graph, const std::vector<double> &cost, int v,
                const std::vector<bool> &onSeam, CutFlags &cut)
{
    std::vector<Way> ways{Way::Any};
    if (graph.isMirrored())
        ways = {graph.onPlane[v] ? Way::AlongPlane : Way::OneSide, Way::Any};
    for (const Way way : ways) {
        std::vector<int> via;
        const std::vector<double> distance = distances(graph, cost, {v}, via, way);
        int nearest = -1;
        for (int w = 0; w < graph.vertexCount; ++w) {
            if (onSeam[w] && distance[w] >= 0 && (nearest < 0 || distance[w] < distance[nearest]))
                nearest = w;
        }
        if (nearest >= 0) {
            cutPath(graph, via, nearest, cut);
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
    openCharts(graph, cost, random, cut);
    if (options.joinBorders)
        joinLoops(graph, cost, Loops::All, cut);
    mirrorCuts(graph, cost, cut);

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
            any |= joinToSeam(graph, cost, v, onSeam, cut);
        }
        mirrorCuts(graph, cost, cut);
        if (!any)
            break;
    }
    return {cut.begin(), cut.end()};
}

} // namespace autocuts::search
