#include "solver/overlap/maxflow.h"

#include <algorithm>
#include <limits>

namespace autocuts::overlap {

MaxFlow::MaxFlow(int nodeCount) : mEnd(nodeCount, Inner)
{
    for (std::vector<int> &steps : mSteps)
        steps.assign(nodeCount, -1);
}

void MaxFlow::addEdge(int a, int b, std::int64_t capacity)
{
    mEdges.push_back({a, b, capacity});
}

void MaxFlow::setTerminal(int node, End end)
{
    mEnd[node] = end;
    mTerminals[end].push_back(node);
}

void MaxFlow::buildArcs()
{
    const std::size_t nodeCount = mEnd.size();
    mFirst.assign(nodeCount + 1, 0);
    for (const Edge &edge : mEdges) {
        ++mFirst[edge.a + 1];
        ++mFirst[edge.b + 1];
    }
    for (std::size_t n = 0; n < nodeCount; ++n)
        mFirst[n + 1] += mFirst[n];
    mArcs.resize(2 * mEdges.size());
    mNext.assign(mFirst.begin(), mFirst.end() - 1);
    for (const Edge &edge : mEdges) {
        const int there = mNext[edge.a]++;
        const int back = mNext[edge.b]++;
        mArcs[there] = {edge.b, back, edge.capacity, edge.capacity};
        mArcs[back] = {edge.a, there, edge.capacity, edge.capacity};
    }
}

//! Visits the nodes one step further from the sources or sinks than those from `head` on.
//! \returns true when one of them was reached from the other end
bool MaxFlow::growFrom(End end, std::size_t &head)
{
    std::vector<int> &reached = mReached[end], &steps = mSteps[end];
    const std::vector<int> &stepsFromOther = mSteps[1 - end];
    bool met = false;
    for (const std::size_t last = reached.size(); head < last; ++head) {
        const int node = reached[head];
        for (int a = mFirst[node]; a < mFirst[node + 1]; ++a) {
            const Arc &arc = end == Sources ? mArcs[a] : mArcs[mArcs[a].reverse];
            const int next = mArcs[a].to;
            if (arc.unused == 0 || steps[next] >= 0)
                continue;
            steps[next] = steps[node] + 1;
            reached.push_back(next);
            met = met || stepsFromOther[next] >= 0;
        }
    }
    return met;
}

//! Searches from both ends, each time on from the one with fewer nodes to visit, until they meet.
//! \returns false when no path with unused capacity is left: mReached of mFound is a side of the cut then
bool MaxFlow::findLevels(Tie tie)
{
    std::array<std::size_t, 2> head{0, 0};
    for (const End end : {Sources, Sinks}) {
        for (const int node : mTerminals[end]) {
            if (mEnd[node] == end && mSteps[end][node] < 0) {
                mSteps[end][node] = 0;
                mReached[end].push_back(node);
            }
        }
    }
    const auto toVisit = [&](End end) { return mReached[end].size() - head[end]; };
    bool met = false;
    while (!met) {
        if (toVisit(Sources) == 0) {
            mFound = Sources;
            return false;
        }
        if (toVisit(Sinks) == 0 && tie == Tie::Quickest) {
            mFound = Sinks;
            return false;
        }
        const bool fromSinks = toVisit(Sinks) > 0 && toVisit(Sinks) < toVisit(Sources);
        const End end = fromSinks ? Sinks : Sources;
        met = growFrom(end, head[end]);
    }
    // All shortest paths have as many steps as the two ends together.
    const int length = mSteps[Sources][mReached[Sources].back()] + mSteps[Sinks][mReached[Sinks].back()];
    for (const int node : mReached[Sources])
        mNext[node] = mFirst[node];
    for (const int node : mReached[Sinks]) {
        mNext[node] = mFirst[node];
        if (mSteps[Sources][node] < 0) {
            mSteps[Sources][node] = length - mSteps[Sinks][node];
            mReached[Sources].push_back(node);
        }
    }
    return true;
}

void MaxFlow::forgetLevels()
{
    mVisits = visits();
    for (const End end : {Sources, Sinks}) {
        for (const int node : mReached[end])
            mSteps[end][node] = -1;
        mReached[end].clear();
    }
}

//! Sends a blocking flow out of one source along shortest paths (Dinic 1970).
std::int64_t MaxFlow::augmentFrom(int source)
{
    const std::vector<int> &level = mSteps[Sources];
    std::int64_t total = 0;
    std::vector<int> path; // arcs from the source
    int node = source;
    for (;;) {
        if (mEnd[node] == Sinks) {
            std::int64_t amount = std::numeric_limits<std::int64_t>::max();
            for (int a : path)
                amount = std::min(amount, mArcs[a].unused);
            std::size_t keep = path.size();
            for (std::size_t i = path.size(); i-- > 0;) {
                Arc &arc = mArcs[path[i]];
                arc.unused -= amount;
                mArcs[arc.reverse].unused += amount;
                mChanged.push_back(path[i]);
                if (arc.unused == 0)
                    keep = i;
            }
            total += amount;
            node = mArcs[mArcs[path[keep]].reverse].to;
            path.resize(keep);
            continue;
        }
        int &next = mNext[node];
        while (next < mFirst[node + 1] &&
               (mArcs[next].unused == 0 || level[mArcs[next].to] != level[node] + 1))
            ++next;
        if (next < mFirst[node + 1]) {
            path.push_back(next);
            node = mArcs[next].to;
        } else if (path.empty()) {
            return total;
        } else {
            node = mArcs[mArcs[path.back()].reverse].to;
            path.pop_back();
            ++mNext[node];
        }
    }
}

std::int64_t MaxFlow::run(Tie tie)
{
    if (mFirst.empty())
        buildArcs();
    std::int64_t flow = 0;
    forgetLevels();
    for (; findLevels(tie); forgetLevels()) {
        for (const int source : mTerminals[Sources]) {
            if (mEnd[source] == Sources)
                flow += augmentFrom(source);
        }
    }
    return flow;
}

std::int64_t MaxFlow::visits() const
{
    return mVisits + static_cast<std::int64_t>(mReached[Sources].size() + mReached[Sinks].size());
}

std::vector<bool> MaxFlow::sourceSide() const
{
    std::vector<bool> onSide(mEnd.size(), mFound != Sources);
    for (const int node : side())
        onSide[node] = mFound == Sources;
    return onSide;
}

void MaxFlow::removeCut()
{
    for (const int a : mChanged) {
        for (Arc *arc : {&mArcs[a], &mArcs[mArcs[a].reverse]})
            arc->unused = arc->capacity;
    }
    mChanged.clear();
    for (const int node : side()) {
        for (int a = mFirst[node]; a < mFirst[node + 1]; ++a) {
            if (mSteps[mFound][mArcs[a].to] >= 0)
                continue;
            for (Arc *arc : {&mArcs[a], &mArcs[mArcs[a].reverse]})
                arc->unused = arc->capacity = 0;
        }
    }
    for (std::vector<int> &terminals : mTerminals) {
        for (const int node : terminals)
            mEnd[node] = Inner;
        terminals.clear();
    }
}

} // namespace autocuts::overlap
