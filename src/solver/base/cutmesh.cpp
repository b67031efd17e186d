#include "solver/base/cutmesh.h"

#include "model/plain/unionfind.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace autocuts {

CutMesh::CutMesh(const MeshData &mesh, const CutFlags &cut) : neighbour(mesh.soupCornerCount(), -1)
{
    UnionFind corners(mesh.soupCornerCount());
    UnionFind triangles(mesh.triangleCount());
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (cut[e])
            continue;
        const EdgePair &pair = mesh.edgePairs[e];
        corners.unite(pair.corner[0][0], pair.corner[0][1]);
        corners.unite(pair.corner[1][0], pair.corner[1][1]);
        triangles.unite(pair.triangle[0], pair.triangle[1]);
        const int side0 = 3 * pair.triangle[0] + pair.side(0);
        const int side1 = 3 * pair.triangle[1] + pair.side(1);
        neighbour[side0] = side1;
        neighbour[side1] = side0;
    }
    std::tie(uvVertex, uvVertexCount) = corners.labels();
    std::tie(chart, chartCount) = triangles.labels();
}

std::vector<std::vector<int>> CutMesh::boundaryLoops() const
{
    const int sides = static_cast<int>(neighbour.size());
    // The boundary side that starts at each UV vertex. A UV vertex is one fan of triangles, so there is at
    // most one.
    std::vector<int> startingAt(uvVertexCount, -1);
    for (int s = 0; s < sides; ++s) {
        if (neighbour[s] < 0)
            startingAt[uvVertex[s]] = s;
    }
    std::vector<std::vector<int>> loops;
    std::vector<bool> seen(sides, false);
    for (int first = 0; first < sides; ++first) {
        if (neighbour[first] >= 0 || seen[first])
            continue;
        std::vector<int> loop;
        for (int s = first; s >= 0 && !seen[s]; s = startingAt[uvVertex[s / 3 * 3 + (s + 1) % 3]]) {
            seen[s] = true;
            loop.push_back(s);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

void dropClosedCuts(const MeshData &mesh, CutFlags &cut)
{
    bool changed = true;
    while (changed) {
        changed = false;
        const CutMesh state(mesh, cut);
        for (std::size_t e = 0; e < cut.size(); ++e) {
            if (!cut[e])
                continue;
            const EdgePair &pair = mesh.edgePairs[e];
            if (state.uvVertex[pair.corner[0][0]] == state.uvVertex[pair.corner[0][1]] &&
                state.uvVertex[pair.corner[1][0]] == state.uvVertex[pair.corner[1][1]]) {
                cut[e] = false;
                changed = true;
            }
        }
    }
}

namespace {

//! Cuts every edge that a spanning tree over the triangles of each component does not cross. The tree
//! contains all diagonals, so that polygons stay whole, and crosses no edge that is cut already.
CutFlags cutOffTree(const MeshData &mesh, const CutFlags &given)
{
    std::vector<std::vector<std::pair<int, int>>> around(mesh.triangleCount()); // (edge, other triangle)
    UnionFind tree(mesh.triangleCount());
    CutFlags cut(mesh.edgePairs.size(), true);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (given[e])
            continue;
        const auto [a, b] = mesh.edgePairs[e].triangle;
        around[a].emplace_back(static_cast<int>(e), b);
        around[b].emplace_back(static_cast<int>(e), a);
        // Diagonals are in the tree from the start: the triangles of a polygon stay connected.
        if (mesh.edgePairs[e].diagonal) {
            tree.unite(a, b);
            cut[e] = false;
        }
    }
    std::vector<bool> seen(mesh.triangleCount(), false);
    std::queue<int> queue;
    for (int start = 0; start < mesh.triangleCount(); ++start) {
        if (seen[start])
            continue;
        seen[start] = true;
        queue.push(start);
        while (!queue.empty()) {
            const int t = queue.front();
            queue.pop();
            for (const auto &[e, other] : around[t]) {
                if (tree.unite(t, other))
                    cut[e] = false;
                if (!seen[other]) {
                    seen[other] = true;
                    queue.push(other);
                }
            }
        }
    }
    return cut;
}

} // namespace

CutFlags cutToDisks(const MeshData &mesh, const CutFlags &given)
{
    const CutFlags before = given.empty() ? CutFlags(mesh.edgePairs.size(), false) : given;
    CutFlags cut = cutOffTree(mesh, before);

    // Prune loose ends: at a vertex inside a chart where only one edge is cut, that cut is removed.
    const CutMesh state(mesh, before);
    std::vector<bool> border(state.uvVertexCount, false);
    std::vector<bool> open(state.chartCount, false);
    for (int side = 0; side < mesh.soupCornerCount(); ++side) {
        if (state.neighbour[side] >= 0)
            continue;
        border[state.uvVertex[side]] = border[state.uvVertex[side / 3 * 3 + (side + 1) % 3]] = true;
        open[state.chart[side / 3]] = true;
    }
    const auto ends = [&](int e) {
        return std::array<int, 2>{state.uvVertex[mesh.edgePairs[e].corner[0][0]],
                                  state.uvVertex[mesh.edgePairs[e].corner[1][0]]};
    };
    std::vector<std::vector<int>> cutsAt(state.uvVertexCount);
    std::vector<int> cutsLeft(state.chartCount, 0);
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (!cut[e] || before[e])
            continue;
        for (const int v : ends(static_cast<int>(e)))
            cutsAt[v].push_back(static_cast<int>(e));
        ++cutsLeft[state.chart[mesh.edgePairs[e].triangle[0]]];
    }
    std::vector<int> degree(state.uvVertexCount);
    std::queue<int> loose;
    for (int v = 0; v < state.uvVertexCount; ++v) {
        degree[v] = static_cast<int>(cutsAt[v].size());
        if (degree[v] == 1 && !border[v])
            loose.push(v);
    }
    while (!loose.empty()) {
        const int v = loose.front();
        loose.pop();
        for (const int e : cutsAt[v]) {
            const int chart = state.chart[mesh.edgePairs[e].triangle[0]];
            // A closed component keeps two cut edges: with fewer it has no border that could be mapped to a
            // circle.
            if (!cut[e] || (!open[chart] && cutsLeft[chart] <= 2))
                continue;
            cut[e] = false;
            --cutsLeft[chart];
            for (const int w : ends(e)) {
                if (--degree[w] == 1 && !border[w])
                    loose.push(w);
            }
        }
    }
    return cut;
}

} // namespace autocuts
