#include "solver/overlap/mincutsplit.h"

#include <algorithm>

namespace autocuts::overlap {

MinCutSplitter::MinCutSplitter(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                               std::vector<int> &part, int &nextPart, const JobContext &job)
    : mGraph(graph), mCapacity(capacity), mPart(part), mNextPart(nextPart), mJob(job), mFinder(graph),
      mLocal(graph.unitCount, -1)
{}

bool MinCutSplitter::exhausted() const
{
    // Bounds the time that the cuts of one chart may take. Chosen by hand.
    constexpr std::int64_t mostVisits = 20'000'000;
    return mVisited > mostVisits || mJob.stopped();
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
        // Short seams first: ordered by an upper bound of their cost, which is quick to compute.
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

//! Upper bound of the cost of separating two layers: cutting out the whole of one layer is always possible;
//! the cheaper of the two counts.
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
    // Earlier cuts may already have separated some of the pairs, or spread the rest over several parts.
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

} // namespace autocuts::overlap
