#include "solver/overlap/mincutsplit.h"

#include "model/unionfind.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace autocuts {

MinCutSplitter::MinCutSplitter(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                               std::vector<int> &part, int &nextPart, const std::atomic<bool> *cancel)
    : mGraph(graph), mCapacity(capacity), mPart(part), mNextPart(nextPart), mCancel(cancel), mFinder(graph),
      mLocal(graph.unitCount, -1)
{
}

bool MinCutSplitter::exhausted() const
{
    constexpr std::int64_t mostVisits = 20'000'000;
    return mVisited > mostVisits || (mCancel && mCancel->load(std::memory_order_relaxed));
}

std::vector<int> MinCutSplitter::split(int label)
{
    mVisited = 0;
    mMembers.clear();
    for (int u = 0; u < mGraph.unitCount; ++u) {
        if (mPart[u] == label)
            mMembers[label].push_back(u);
    }
    std::vector<int> open{label};
    while (!open.empty() && !exhausted()) {
        const int current = open.back();
        open.pop_back();
        std::vector<Sheets> all = mFinder.find(mPart, mMembers[current]);
        // A bound on the seam is enough to cut the short ones first.
        std::vector<std::pair<std::int64_t, std::size_t>> order;
        for (std::size_t i = 0; i < all.size(); ++i)
            order.emplace_back(perimeterBound(all[i]), i);
        std::sort(order.begin(), order.end());
        std::vector<int> touched;
        if (!all.empty())
            touched.push_back(current);
        for (const auto &[bound, i] : order) {
            if (!exhausted())
                cutBetween(all[i], touched);
        }
        open.insert(open.end(), touched.begin(), touched.end());
    }
    return open;
}

//! Cutting out the whole of one layer is always possible; the cheaper of the two.
std::int64_t MinCutSplitter::perimeterBound(const Sheets &sheets) const
{
    std::vector<int> layers[2];
    for (const auto &[first, second] : sheets) {
        layers[0].push_back(first);
        layers[1].push_back(second);
    }
    std::int64_t bound[2] = {0, 0};
    for (int k = 0; k < 2; ++k) {
        std::vector<int> &layer = layers[k];
        std::sort(layer.begin(), layer.end());
        layer.erase(std::unique(layer.begin(), layer.end()), layer.end());
        for (int unit : layer) {
            for (int link : mGraph.linksOfUnit[unit]) {
                const int other = mGraph.across(link, unit);
                if (mPart[other] == mPart[unit] && !std::binary_search(layer.begin(), layer.end(), other))
                    bound[k] += mCapacity[link];
            }
        }
    }
    return std::min(bound[0], bound[1]);
}

void MinCutSplitter::cutBetween(const Sheets &sheets, std::vector<int> &touched)
{
    // Earlier cuts may have separated some of the pairs already, or spread the rest over several labels.
    std::map<int, Sheets> left;
    for (const auto &[first, second] : sheets) {
        if (mPart[first] == mPart[second])
            left[mPart[first]].emplace_back(first, second);
    }
    for (const auto &[label, pairs] : left)
        cutLabel(label, pairs, touched);
}

void MinCutSplitter::cutLabel(int label, const Sheets &sheets, std::vector<int> &touched)
{
    std::vector<int> &members = mMembers[label];
    mVisited += static_cast<std::int64_t>(members.size());
    for (std::size_t i = 0; i < members.size(); ++i)
        mLocal[members[i]] = static_cast<int>(i);
    MaxFlow flow(static_cast<int>(members.size()));
    for (int unit : members) {
        for (int link : mGraph.linksOfUnit[unit]) {
            const int other = mGraph.across(link, unit);
            if (unit < other && mPart[other] == label)
                flow.addEdge(mLocal[unit], mLocal[other], mCapacity[link]);
        }
    }
    for (const auto &[first, second] : sheets) {
        flow.setSource(mLocal[first]);
        flow.setSink(mLocal[second]);
    }
    flow.run();

    std::vector<int> kept, moved;
    for (std::size_t i = 0; i < members.size(); ++i)
        (flow.sourceSide()[i] ? kept : moved).push_back(members[i]);
    for (int unit : moved)
        mPart[unit] = mNextPart;
    members = std::move(kept);
    mMembers[mNextPart] = std::move(moved);
    touched.push_back(mNextPart++);
}

namespace {

//! Parts, what they share and what keeps them apart, while they are being merged.
class PartMerger
{
public:
    PartMerger(const UnitGraph &graph, const std::vector<std::int64_t> &capacity, std::vector<int> &part);
    void run();

private:
    void merge(int into, int from);
    int find(int part);

    std::vector<int> &mPart;
    std::vector<int> mMerged;                             //!< part that each part went into, or itself
    std::vector<std::map<int, std::int64_t>> mShared;     //!< cost of the seams with each neighbour
    std::vector<std::set<int>> mConflicts;
    std::set<std::tuple<std::int64_t, int, int>> mQueue;  //!< (-cost, a, b), a < b
};

PartMerger::PartMerger(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                       std::vector<int> &part)
    : mPart(part)
{
    const int count = part.empty() ? 0 : 1 + *std::max_element(part.begin(), part.end());
    mMerged.resize(count);
    for (int p = 0; p < count; ++p)
        mMerged[p] = p;
    mShared.resize(count);
    mConflicts.resize(count);
    for (std::size_t l = 0; l < graph.links.size(); ++l) {
        const int a = part[graph.links[l].a];
        const int b = part[graph.links[l].b];
        if (a != b) {
            mShared[a][b] += capacity[l];
            mShared[b][a] += capacity[l];
        }
    }
    for (int u = 0; u < graph.unitCount; ++u) {
        for (int v : graph.conflicts[u]) {
            if (part[u] != part[v])
                mConflicts[part[u]].insert(part[v]);
        }
    }
    for (int a = 0; a < count; ++a) {
        for (const auto &[b, cost] : mShared[a]) {
            if (a < b)
                mQueue.insert({-cost, a, b});
        }
    }
}

void PartMerger::run()
{
    while (!mQueue.empty()) {
        auto [cost, a, b] = *mQueue.begin();
        mQueue.erase(mQueue.begin());
        if (mConflicts[a].count(b) > 0)
            continue;
        const auto size = [&](int p) { return mShared[p].size() + mConflicts[p].size(); };
        if (size(a) < size(b))
            std::swap(a, b);
        merge(a, b);
    }
    for (int &p : mPart)
        p = find(p);
}

void PartMerger::merge(int into, int from)
{
    mMerged[from] = into;
    for (const auto &[other, cost] : mShared[from]) {
        mQueue.erase({-cost, std::min(from, other), std::max(from, other)});
        mShared[other].erase(from);
        if (other == into)
            continue;
        std::int64_t &common = mShared[into][other];
        mQueue.erase({-common, std::min(into, other), std::max(into, other)});
        common += cost;
        mShared[other][into] = common;
        mQueue.insert({-common, std::min(into, other), std::max(into, other)});
    }
    for (int other : mConflicts[from]) {
        mConflicts[other].erase(from);
        mConflicts[other].insert(into);
        mConflicts[into].insert(other);
    }
    mShared[from].clear();
    mConflicts[from].clear();
}

int PartMerger::find(int part)
{
    while (mMerged[part] != part)
        part = mMerged[part] = mMerged[mMerged[part]];
    return part;
}

} // namespace

void mergeCleanParts(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                     std::vector<int> &part)
{
    // A label may have fallen into several pieces; each can be joined on its own.
    UnionFind pieces(graph.unitCount);
    for (const UnitGraph::Link &link : graph.links) {
        if (part[link.a] == part[link.b])
            pieces.unite(link.a, link.b);
    }
    part = pieces.labels().first;
    PartMerger(graph, capacity, part).run();
}

} // namespace autocuts
