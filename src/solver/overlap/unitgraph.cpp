#include "solver/overlap/unitgraph.h"

#include "model/plain/unionfind.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace autocuts::overlap {

namespace {

//! Adjacency lists of unordered pairs: sorted, each neighbour once.
CsrList symmetricLists(int count, std::vector<std::pair<int, int>> pairs)
{
    const std::size_t size = pairs.size();
    pairs.reserve(2 * size);
    for (std::size_t i = 0; i < size; ++i)
        pairs.emplace_back(pairs[i].second, pairs[i].first);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return {count, pairs};
}

} // namespace

UnitGraph makeUnitGraph(const MeshData &mesh, const std::vector<bool> &cut,
                        const std::vector<bool> &protectedPair, const std::vector<OverlapPair> &overlaps)
{
    UnitGraph graph;
    const int pairCount = static_cast<int>(mesh.edgePairs.size());
    UnionFind sets(mesh.triangleCount());
    for (int p = 0; p < pairCount; ++p) {
        const EdgePair &pair = mesh.edgePairs[p];
        if (pair.diagonal || (!cut[p] && !protectedPair.empty() && protectedPair[p]))
            sets.unite(pair.triangle[0], pair.triangle[1]);
    }
    std::tie(graph.unitOfTriangle, graph.unitCount) = sets.labels();

    std::vector<std::pair<int, int>> members, ends, pairs;
    for (int t = 0; t < mesh.triangleCount(); ++t)
        members.emplace_back(graph.unitOfTriangle[t], t);
    graph.triangles = {graph.unitCount, members};
    for (int p = 0; p < pairCount; ++p) {
        const int a = graph.unitOfTriangle[mesh.edgePairs[p].triangle[0]];
        const int b = graph.unitOfTriangle[mesh.edgePairs[p].triangle[1]];
        if (cut[p] || a == b)
            continue;
        ends.emplace_back(a, static_cast<int>(graph.links.size()));
        ends.emplace_back(b, static_cast<int>(graph.links.size()));
        pairs.emplace_back(a, b);
        graph.links.push_back({p, a, b});
    }
    graph.linksOfUnit = {graph.unitCount, ends};
    graph.neighbours = symmetricLists(graph.unitCount, std::move(pairs));

    pairs.clear();
    for (const OverlapPair &overlap : overlaps) {
        const int a = graph.unitOfTriangle[overlap.first];
        const int b = graph.unitOfTriangle[overlap.second];
        if (a == b)
            ++graph.innerOverlaps;
        else
            pairs.emplace_back(a, b);
    }
    graph.conflicts = symmetricLists(graph.unitCount, std::move(pairs));
    return graph;
}

std::vector<int> chartsOfCut(const MeshData &mesh, const std::vector<bool> &cut)
{
    UnionFind sets(mesh.triangleCount());
    for (std::size_t p = 0; p < mesh.edgePairs.size(); ++p) {
        if (!cut[p] || mesh.edgePairs[p].diagonal)
            sets.unite(mesh.edgePairs[p].triangle[0], mesh.edgePairs[p].triangle[1]);
    }
    return sets.labels().first;
}

ChartConflicts conflictsOfChart(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                                int seedTriangle, const OverlapOptions &options)
{
    if (soupUv.rows() != mesh.soupCornerCount() || cut.size() != mesh.edgePairs.size() || seedTriangle < 0 ||
        seedTriangle >= mesh.triangleCount())
        throw std::invalid_argument("a size does not fit the mesh");
    ChartConflicts result;
    const std::vector<int> chart = chartsOfCut(mesh, cut);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (chart[t] == chart[seedTriangle])
            result.triangles.push_back(t);
    }
    OverlapOptions relative = options;
    if (!(relative.totalArea > 0))
        relative.totalArea = totalUvArea(soupUv);
    const OverlapList overlaps = findOverlapsAmong(soupUv, result.triangles, relative);
    result.complete = overlaps.complete;
    result.graph = makeUnitGraph(mesh, cut, {}, overlaps.pairs);
    return result;
}

} // namespace autocuts::overlap
