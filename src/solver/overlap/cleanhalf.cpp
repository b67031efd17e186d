#include "solver/overlap/cleanhalf.h"

#include "solver/overlap/maxflow.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace autocuts::overlap {

namespace {

//! A connected set of units in the graph of overlaps, split into two layers: units of one layer overlap only
//! units of the other, so the layers must be in different parts.
struct Layers
{
    std::array<std::vector<int>, 2> units;

    std::size_t size() const { return units[0].size() + units[1].size(); }
};

//! The layers of all overlaps among `members`: first those of the seed, then by falling size. Nothing when
//! some set of overlapping units cannot be split into two layers.
std::optional<std::vector<Layers>> findLayers(const UnitGraph &graph, const std::vector<int> &members,
                                              int seed)
{
    std::vector<int> side(graph.unitCount, -1);
    std::vector<Layers> all;
    const auto collect = [&](int start) {
        Layers layers;
        std::vector<int> queue{start};
        side[start] = 0;
        for (std::size_t head = 0; head < queue.size(); ++head) {
            const int unit = queue[head];
            layers.units[side[unit]].push_back(unit);
            for (int other : graph.conflicts[unit]) {
                if (side[other] == side[unit])
                    return false;
                if (side[other] < 0)
                    queue.push_back(other);
                side[other] = 1 - side[unit];
            }
        }
        if (queue.size() > 1)
            all.push_back(std::move(layers));
        return true;
    };
    if (!collect(seed))
        return std::nullopt;
    const auto others = static_cast<std::ptrdiff_t>(all.size());
    for (int unit : members) {
        if (side[unit] < 0 && !collect(unit))
            return std::nullopt;
    }
    std::stable_sort(all.begin() + others, all.end(),
                     [](const Layers &a, const Layers &b) { return a.size() > b.size(); });
    return all;
}

//! Splits a chart into two parts by minimum cuts: the near part has the seed.
class TwoParts
{
public:
    TwoParts(const MeshData &mesh, const UnitGraph &graph, const std::vector<int> &members)
        : mGraph(graph), mMembers(members), mLocal(graph.unitCount, -1), mCapacity(graph.links.size())
    {
        double longest = 0;
        for (const UnitGraph::Link &link : graph.links)
            longest = std::max(longest, mesh.edgePairs[link.pair].length);
        for (std::size_t l = 0; l < mCapacity.size(); ++l) {
            const double share = longest > 0 ? mesh.edgePairs[graph.links[l].pair].length / longest : 0;
            mCapacity[l] = 1 + std::llround(share * (1 << 20));
        }
        for (std::size_t i = 0; i < members.size(); ++i)
            mLocal[members[i]] = static_cast<int>(i);
    }

    void fix(const std::vector<int> &near, const std::vector<int> &far)
    {
        mNear.insert(mNear.end(), near.begin(), near.end());
        mFar.insert(mFar.end(), far.begin(), far.end());
    }

    //! Index (0 or 1) of the layer that is cheaper to have in the near part.
    int cheaper(const Layers &layers) const
    {
        const std::int64_t cost[2] = {flow(layers.units[0], layers.units[1]).run(),
                                      flow(layers.units[1], layers.units[0]).run()};
        return cost[0] <= cost[1] ? 0 : 1;
    }

    //! Per unit of the mesh: true when it is in the near part.
    std::vector<bool> part() const
    {
        MaxFlow last = flow({}, {});
        last.run();
        std::vector<bool> near(mGraph.unitCount, false);
        for (int unit : mMembers)
            near[unit] = true;
        for (int local : last.side())
            near[mMembers[local]] = false;
        return near;
    }

private:
    //! The far units are the source: of several minimum cuts the one with the smallest far part is found.
    MaxFlow flow(const std::vector<int> &near, const std::vector<int> &far) const
    {
        MaxFlow flow(static_cast<int>(mMembers.size()));
        for (int unit : mMembers) {
            for (int link : mGraph.linksOfUnit[unit]) {
                const int other = mGraph.across(link, unit);
                if (unit < other && mLocal[other] >= 0)
                    flow.addEdge(mLocal[unit], mLocal[other], mCapacity[link]);
            }
        }
        for (const std::vector<int> *units : {&mFar, &far}) {
            for (int unit : *units)
                flow.setSource(mLocal[unit]);
        }
        for (const std::vector<int> *units : {&mNear, &near}) {
            for (int unit : *units)
                flow.setSink(mLocal[unit]);
        }
        return flow;
    }

    const UnitGraph &mGraph;
    const std::vector<int> &mMembers;
    std::vector<int> mLocal;
    std::vector<std::int64_t> mCapacity;
    std::vector<int> mNear, mFar;
};

} // namespace

std::vector<int> cleanHalf(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                           int seedTriangle, const OverlapOptions &options)
{
    const auto isCancelled = [&] { return options.job.stopped(); };
    ChartConflicts conflicts = conflictsOfChart(mesh, soupUv, cut, seedTriangle, options);
    if (!conflicts.complete)
        return {};
    std::vector<int> &triangles = conflicts.triangles;
    const UnitGraph &graph = conflicts.graph;
    std::vector<int> members;
    for (int t : triangles) {
        if (members.empty() || members.back() != graph.unitOfTriangle[t])
            members.push_back(graph.unitOfTriangle[t]);
    }
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    const int seed = graph.unitOfTriangle[seedTriangle];
    const std::optional<std::vector<Layers>> layers = findLayers(graph, members, seed);
    if (!layers)
        return {};

    TwoParts parts(mesh, graph, members);
    parts.fix({seed}, {});
    for (const Layers &each : *layers) {
        if (isCancelled())
            return {};
        const bool hasSeed = each.units[0].front() == seed;
        const int near = hasSeed ? 0 : parts.cheaper(each);
        parts.fix(each.units[near], each.units[1 - near]);
    }
    const std::vector<bool> near = parts.part();
    std::erase_if(triangles, [&](int t) { return !near[graph.unitOfTriangle[t]]; });
    return triangles;
}

} // namespace autocuts::overlap
