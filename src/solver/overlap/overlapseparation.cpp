#include "solver/overlap/overlapseparation.h"

#include "solver/overlap/cleanregion.h"
#include "solver/overlap/mincutsplit.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/partjoining.h"
#include "solver/overlap/unitgraph.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::overlap {

namespace {

void checkSizes(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                const std::vector<bool> &protectedPair, const SeparationOptions &options)
{
    const std::size_t pairs = mesh.edgePairs.size();
    const auto fits = [&](std::size_t size) { return size == 0 || size == pairs; };
    if (soupUv.rows() != mesh.soupCornerCount() || cut.size() != pairs || !fits(protectedPair.size()) ||
        !fits(options.pairWeight.size()))
        throw std::invalid_argument("a size does not fit the mesh");
}

//! Units in breadth-first order over uncut links, from the first one of `members`. Units that cannot be
//! reached come last.
std::vector<int> breadthFirst(const UnitGraph &graph, const std::vector<int> &members,
                              const std::vector<int> &part)
{
    std::vector<int> order;
    std::vector<bool> seen(graph.unitCount, false);
    for (int start : members) {
        if (seen[start])
            continue;
        seen[start] = true;
        std::size_t head = order.size();
        order.push_back(start);
        for (; head < order.size(); ++head) {
            for (int next : graph.neighbours[order[head]]) {
                if (!seen[next] && part[next] == part[start]) {
                    seen[next] = true;
                    order.push_back(next);
                }
            }
        }
    }
    return order;
}

//! Collects the overlapping triangle pairs inside each chart. A chart with more pairs than
//! OverlapOptions::maxPairs (thousands of layers) is halved, regardless of seam length, until each half has
//! fewer.
class OverlapCollector
{
public:
    OverlapCollector(const UnitGraph &graph, const UvMatrix &soupUv, OverlapOptions options)
        : mGraph(graph), mUv(soupUv), mOptions(options)
    {}

    //! \param part the part of each unit; charts that are halved get new parts
    //! \return false when cancelled
    bool run(std::vector<int> &part, int &nextPart)
    {
        std::vector<std::vector<int>> open(nextPart);
        for (int u = 0; u < mGraph.unitCount; ++u)
            open[part[u]].push_back(u);
        while (!open.empty()) {
            std::vector<int> members = std::move(open.back());
            open.pop_back();
            std::vector<int> triangles;
            for (int u : members)
                triangles.insert(triangles.end(), mGraph.triangles[u].begin(), mGraph.triangles[u].end());
            OverlapList list = findOverlapsAmong(mUv, triangles, mOptions);
            if (mOptions.job.stopped())
                return false;
            if (list.complete || members.size() == 1) {
                pairs.insert(pairs.end(), list.pairs.begin(), list.pairs.end());
                continue;
            }
            const std::vector<int> order = breadthFirst(mGraph, members, part);
            const auto half = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
            std::for_each(half, order.end(), [&](int u) { part[u] = nextPart; });
            ++nextPart;
            open.emplace_back(order.begin(), half);
            open.emplace_back(half, order.end());
        }
        return true;
    }

    std::vector<OverlapPair> pairs;

private:
    const UnitGraph &mGraph;
    const UvMatrix &mUv;
    OverlapOptions mOptions;
};

//! Cost of every link as an integer: length times weight, scaled so that the dearest costs about 2^30.
std::vector<std::int64_t> linkCapacities(const MeshData &mesh, const UnitGraph &graph,
                                         const std::vector<double> &weight)
{
    std::vector<double> cost(graph.links.size());
    double most = 0;
    for (std::size_t l = 0; l < cost.size(); ++l) {
        const int pair = graph.links[l].pair;
        cost[l] = mesh.edgePairs[pair].length * (weight.empty() ? 1.0 : std::max(0.0, weight[pair]));
        if (!std::isfinite(cost[l]))
            cost[l] = 0;
        most = std::max(most, cost[l]);
    }
    std::vector<std::int64_t> capacity(cost.size(), 1);
    for (std::size_t l = 0; l < cost.size() && most > 0; ++l)
        capacity[l] += std::llround(std::ldexp(cost[l] / most, 30));
    return capacity;
}

//! Parts that hold two overlapping units.
std::vector<int> overlappingParts(const UnitGraph &graph, const std::vector<int> &part)
{
    std::vector<int> labels;
    for (int u = 0; u < graph.unitCount; ++u) {
        const auto conflicts = graph.conflicts[u];
        if (std::any_of(conflicts.begin(), conflicts.end(), [&](int v) { return part[v] == part[u]; }))
            labels.push_back(part[u]);
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    return labels;
}

void splitParts(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                const SeparationOptions &options, std::vector<int> &part, int &nextPart)
{
    MinCutSplitter splitter(graph, capacity, part, nextPart, options.job);
    for (int label : overlappingParts(graph, part)) {
        if (options.method == SeparationMethod::Greedy) {
            splitIntoCleanRegions(graph, label, part, nextPart);
            continue;
        }
        for (int left : splitter.split(label))
            splitIntoCleanRegions(graph, left, part, nextPart);
    }
}

void cutBetweenParts(const MeshData &mesh, const UnitGraph &graph, const std::vector<int> &part,
                     SeparationResult &result)
{
    for (const UnitGraph::Link &link : graph.links) {
        if (part[link.a] == part[link.b])
            continue;
        result.cut[link.pair] = true;
        ++result.newSeams;
        result.newSeamLength += mesh.edgePairs[link.pair].length;
    }
}

} // namespace

SeparationResult separateOverlaps(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                                  const std::vector<bool> &protectedPair, const SeparationOptions &options)
{
    checkSizes(mesh, soupUv, cut, protectedPair, options);
    SeparationResult result;
    result.cut = cut;
    UnitGraph graph = makeUnitGraph(mesh, cut, protectedPair, {});
    const std::vector<int> chart = chartsOfCut(mesh, cut);
    std::vector<int> part(graph.unitCount);
    int nextPart = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        part[graph.unitOfTriangle[t]] = chart[t];
        nextPart = std::max(nextPart, chart[t] + 1);
    }

    OverlapOptions search;
    search.minAreaRatio = options.minAreaRatio;
    search.totalArea = totalUvArea(soupUv);
    search.maxPairs = 8'000'000;
    search.job = options.job;
    OverlapCollector collector(graph, soupUv, search);
    result.complete = collector.run(part, nextPart);
    if (!result.complete)
        return result;
    result.overlapPairs = static_cast<std::int64_t>(collector.pairs.size());
    if (collector.pairs.empty())
        return result;

    // Overlaps between the halves of a halved chart are unknown, so the seam between them stays.
    cutBetweenParts(mesh, graph, part, result);
    graph = makeUnitGraph(mesh, result.cut, protectedPair, collector.pairs);
    result.unresolvedPairs = graph.innerOverlaps;
    const std::vector<std::int64_t> capacity = linkCapacities(mesh, graph, options.pairWeight);
    splitParts(graph, capacity, options, part, nextPart);
    joinCleanParts(graph, capacity, part);
    if (options.job.stopped()) {
        result = {};
        result.cut = cut;
        result.complete = false;
        return result;
    }
    cutBetweenParts(mesh, graph, part, result);
    return result;
}

} // namespace autocuts::overlap
