#include "solver/overlap/maxflow.h"

#include <algorithm>
#include <limits>

namespace autocuts::overlap {

MaxFlow::MaxFlow(int nodeCount) : mSide(nodeCount, Inner) {}

void MaxFlow::addEdge(int a, int b, std::int64_t capacity)
{
    mEdges.push_back({a, b, capacity});
}

void MaxFlow::buildArcs()
{
    const int nodeCount = static_cast<int>(mSide.size());
    mFirst.assign(nodeCount + 1, 0);
    for (const Edge &edge : mEdges) {
        ++mFirst[edge.a + 1];
        ++mFirst[edge.b + 1];
    }
    for (int n = 0; n < nodeCount; ++n)
        mFirst[n + 1] += mFirst[n];
    mArcs.resize(2 * mEdges.size());
    std::vector<int> place(mFirst.begin(), mFirst.end() - 1);
    for (const Edge &edge : mEdges) {
        const int there = place[edge.a]++;
        const int back = place[edge.b]++;
        mArcs[there] = {edge.b, back, edge.capacity};
        mArcs[back] = {edge.a, there, edge.capacity};
    }
}

bool MaxFlow::findLevels()
{
    mLevel.assign(mSide.size(), -1);
    std::vector<int> queue;
    for (int n = 0; n < static_cast<int>(mSide.size()); ++n) {
        if (mSide[n] == Source) {
            mLevel[n] = 0;
            queue.push_back(n);
        }
    }
    bool sinkFound = false;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const int node = queue[head];
        for (int a = mFirst[node]; a < mFirst[node + 1]; ++a) {
            const int to = mArcs[a].to;
            if (mArcs[a].capacity == 0 || mLevel[to] >= 0)
                continue;
            mLevel[to] = mLevel[node] + 1;
            sinkFound = sinkFound || mSide[to] == Sink;
            if (mSide[to] != Sink)
                queue.push_back(to);
        }
    }
    return sinkFound;
}

//! Sends a blocking flow out of one source along rising levels (Dinic 1970).
std::int64_t MaxFlow::augmentFrom(int source)
{
    std::int64_t total = 0;
    std::vector<int> path; // arcs from the source
    int node = source;
    for (;;) {
        if (mSide[node] == Sink) {
            std::int64_t amount = std::numeric_limits<std::int64_t>::max();
            for (int a : path)
                amount = std::min(amount, mArcs[a].capacity);
            std::size_t keep = path.size();
            for (std::size_t i = path.size(); i-- > 0;) {
                Arc &arc = mArcs[path[i]];
                arc.capacity -= amount;
                mArcs[arc.reverse].capacity += amount;
                if (arc.capacity == 0)
                    keep = i;
            }
            total += amount;
            node = mArcs[mArcs[path[keep]].reverse].to;
            path.resize(keep);
            continue;
        }
        int &next = mNext[node];
        while (next < mFirst[node + 1] &&
               (mArcs[next].capacity == 0 || mLevel[mArcs[next].to] != mLevel[node] + 1))
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

std::int64_t MaxFlow::run()
{
    buildArcs();
    std::int64_t flow = 0;
    while (findLevels()) {
        mNext.assign(mFirst.begin(), mFirst.end() - 1);
        for (int n = 0; n < static_cast<int>(mSide.size()); ++n) {
            if (mSide[n] == Source)
                flow += augmentFrom(n);
        }
    }
    // The last search reached exactly the nodes on the source's side of the cut.
    mReached.resize(mLevel.size());
    for (std::size_t n = 0; n < mLevel.size(); ++n)
        mReached[n] = mLevel[n] >= 0;
    return flow;
}

} // namespace autocuts::overlap
