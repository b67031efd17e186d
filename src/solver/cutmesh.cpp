#include "solver/cutmesh.h"

#include "model/unionfind.h"

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
    // The boundary side that starts at each UV vertex; a fan of triangles has exactly one.
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
            if (state.uvVertex[pair.corner[0][0]] == state.uvVertex[pair.corner[0][1]]
                && state.uvVertex[pair.corner[1][0]] == state.uvVertex[pair.corner[1][1]]) {
                cut[e] = false;
                changed = true;
            }
        }
    }
}

namespace {

//! Mesh vertices by fans, not by position: corners tied by any edge pair. Keeps bow-ties apart.
std::vector<int> fanVertices(const MeshData &mesh)
{
    UnionFind sets(mesh.soupCornerCount());
    for (const EdgePair &pair : mesh.edgePairs) {
        sets.unite(pair.corner[0][0], pair.corner[0][1]);
        sets.unite(pair.corner[1][0], pair.corner[1][1]);
    }
    return sets.labels().first;
}

} // namespace

CutFlags cutToDisks(const MeshData &mesh)
{
    const int edges = static_cast<int>(mesh.edgePairs.size());
    std::vector<std::vector<std::pair<int, int>>> around(mesh.triangleCount());    // (edge, other triangle)
    for (int e = 0; e < edges; ++e) {
        const auto [a, b] = mesh.edgePairs[e].triangle;
        around[a].emplace_back(e, b);
        around[b].emplace_back(e, a);
    }
    // Diagonals first, so that polygons stay whole.
    for (auto &list : around) {
        std::stable_sort(list.begin(), list.end(), [&](const auto &a, const auto &b) {
            return mesh.edgePairs[a.first].diagonal > mesh.edgePairs[b.first].diagonal;
        });
    }
    CutFlags cut(edges, true);
    for (int e = 0; e < edges; ++e)
        cut[e] = !mesh.edgePairs[e].diagonal;
    // The diagonals are in the tree from the start: their faces are its first pieces.
    UnionFind tree(mesh.triangleCount());
    for (const EdgePair &pair : mesh.edgePairs) {
        if (pair.diagonal)
            tree.unite(pair.triangle[0], pair.triangle[1]);
    }
    std::vector<bool> seen(mesh.triangleCount(), false);
    for (int start = 0; start < mesh.triangleCount(); ++start) {
        if (seen[start])
            continue;
        std::queue<int> queue;
        queue.push(start);
        seen[start] = true;
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

    // Prune loose ends: vertices off the border with a single cut edge.
    const std::vector<int> vertex = fanVertices(mesh);
    const int vertices = vertex.empty() ? 0 : *std::max_element(vertex.begin(), vertex.end()) + 1;
    std::vector<bool> border(vertices, false);
    for (const BoundarySide &side : mesh.boundarySides) {
        border[vertex[3 * side.triangle + side.side]] = true;
        border[vertex[3 * side.triangle + (side.side + 1) % 3]] = true;
    }
    std::vector<std::vector<int>> cutsAt(vertices);
    std::vector<int> cutsLeft(mesh.componentCount, 0);
    std::vector<bool> open(mesh.componentCount, false);
    for (const BoundarySide &side : mesh.boundarySides)
        open[mesh.component[side.triangle]] = true;
    const auto ends = [&](int e) {
        return std::array<int, 2>{vertex[mesh.edgePairs[e].corner[0][0]],
                                  vertex[mesh.edgePairs[e].corner[1][0]]};
    };
    for (int e = 0; e < edges; ++e) {
        if (!cut[e])
            continue;
        for (const int v : ends(e))
            cutsAt[v].push_back(e);
        ++cutsLeft[mesh.component[mesh.edgePairs[e].triangle[0]]];
    }
    std::vector<int> degree(vertices);
    std::queue<int> loose;
    for (int v = 0; v < vertices; ++v) {
        degree[v] = static_cast<int>(cutsAt[v].size());
        if (degree[v] == 1 && !border[v])
            loose.push(v);
    }
    while (!loose.empty()) {
        const int v = loose.front();
        loose.pop();
        for (const int e : cutsAt[v]) {
            const int component = mesh.component[mesh.edgePairs[e].triangle[0]];
            // A sphere keeps two edges: with fewer there is no border to map to a circle.
            if (!cut[e] || (!open[component] && cutsLeft[component] <= 2))
                continue;
            cut[e] = false;
            --cutsLeft[component];
            for (const int w : ends(e)) {
                if (--degree[w] == 1 && !border[w])
                    loose.push(w);
            }
        }
    }
    return cut;
}

} // namespace autocuts
