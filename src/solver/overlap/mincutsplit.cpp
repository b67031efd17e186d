#include "solver/overlap/mincutsplit.h"

#include <algorithm>

namespace autocuts::overlap {

MinCutSplitter::MinCutSplitter(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                               std::vector<int> &part, int &nextPart, const JobContext &job)
    : mGraph(graph), mCapacity(capacity), mPart(part), mNextPart(nextPart), mJob(job), mFinder(graph),
      mLocal(graph.unitCount, -1)
{}

bool MinCutSplitter::exhausted(const MaxFlow &flow) const
{
    // Bounds the time that the cuts of one chart may take. Chosen by hand.
    constexpr std::int64_t mostVisits = 50'000'000;
    return flow.visits() > mostVisits || mJob.stopped();
}

//! The units of one part and the links between them.
MaxFlow MinCutSplitter::flowOf(int label)
{
    mUnits.clear();
    for (int u = 0; u < mGraph.unitCount; ++u) {
        if (mPart[u] != label)
            continue;
        mLocal[u] = static_cast<int>(mUnits.size());
        mUnits.push_back(u);
    }
    MaxFlow flow(static_cast<int>(mUnits.size()));
    for (const int unit : mUnits) {
        for (const int link : mGraph.linksOfUnit[unit]) {
            const int other = mGraph.across(link, unit);
            if (unit < other && mPart[other] == label)
                flow.addEdge(mLocal[unit], mLocal[other], mCapacity[link]);
        }
    }
    return flow;
}

std::vector<int> MinCutSplitter::split(int label)
{
    MaxFlow flow = flowOf(label);
    mMembers.clear();
    mMembers[label] = mUnits;
    std::vector<int> open{label};
    while (!open.empty() && !exhausted(flow)) {
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
            if (!exhausted(flow))
                cutBetween(all[i], flow, touched);
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

void MinCutSplitter::cutBetween(const Sheets &sheets, MaxFlow &flow, std::vector<int> &touched)
{
    // Earlier cuts may already have separated some of the pairs, or spread the rest over several parts.
    std::map<int, Sheets> left;
    for (const auto &[first, second] : sheets) {
        if (mPart[first] == mPart[second])
            left[mPart[first]].emplace_back(first, second);
    }
    for (const auto &[label, pairs] : left)
        cutLabel(label, pairs, flow, touched);
}

void MinCutSplitter::cutLabel(int label, const Sheets &sheets, MaxFlow &flow, std::vector<int> &touched)
{
    for (const auto &[first, second] : sheets) {
        flow.setSource(mLocal[first]);
        flow.setSink(mLocal[second]);
    }
    flow.run(MaxFlow::Tie::Quickest);
    std::vector<int> &moved = mMembers[mNextPart];
    for (const int local : flow.side()) {
        moved.push_back(mUnits[local]);
        mPart[mUnits[local]] = mNextPart;
    }
    flow.removeCut();
    std::sort(moved.begin(), moved.end());
    std::erase_if(mMembers[label], [this](int unit) { return mPart[unit] == mNextPart; });
    touched.push_back(mNextPart++);
}

} // namespace autocuts::overlap
