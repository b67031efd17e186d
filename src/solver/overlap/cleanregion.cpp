#include "solver/overlap/cleanregion.h"

#include "solver/overlap/unitgraph.h"

#include <algorithm>

namespace autocuts::overlap {

namespace {

//! Labels a region around the seed with `to`, using only units labelled `from`. The region grows breadth
//! first and leaves out units that overlap it.
void growRegion(const UnitGraph &graph, int seed, int from, int to, std::vector<int> &part)
{
    std::vector<int> queue{seed};
    part[seed] = to;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        for (int unit : graph.neighbours[queue[head]]) {
            if (part[unit] != from)
                continue;
            const auto conflicts = graph.conflicts[unit];
            if (std::any_of(conflicts.begin(), conflicts.end(), [&](int c) { return part[c] == to; }))
                continue;
            part[unit] = to;
            queue.push_back(unit);
        }
    }
}

} // namespace

std::vector<int> cleanRegion(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                             int seedTriangle, const OverlapOptions &options)
{
    const UnitGraph graph = conflictsOfChart(mesh, soupUv, cut, seedTriangle, options).graph;
    std::vector<int> part(graph.unitCount, 0);
    growRegion(graph, graph.unitOfTriangle[seedTriangle], 0, 1, part);

    std::vector<int> region;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (part[graph.unitOfTriangle[t]] == 1)
            region.push_back(t);
    }
    return region;
}

void splitIntoCleanRegions(const UnitGraph &graph, int from, std::vector<int> &part, int &nextPart)
{
    std::vector<int> seeds;
    for (int u = 0; u < graph.unitCount; ++u) {
        if (part[u] == from)
            seeds.push_back(u);
    }
    std::stable_sort(seeds.begin(), seeds.end(),
                     [&](int a, int b) { return graph.conflicts[a].size() < graph.conflicts[b].size(); });
    for (int seed : seeds) {
        if (part[seed] == from)
            growRegion(graph, seed, from, nextPart++, part);
    }
}

} // namespace autocuts::overlap
