#include "solver/overlap/partjoining.h"

#include "model/plain/unionfind.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace autocuts::overlap {

namespace {

//! Joins parts in the order of their common seams: keeps the seam cost and the overlaps between parts.
class PartJoiner
{
public:
    PartJoiner(const UnitGraph &graph, const std::vector<std::int64_t> &capacity, std::vector<int> &part);
    void run();

private:
    void join(int into, int from);
    int find(int part);

    std::vector<int> &mPart;
    std::vector<int> mJoined;                         //!< the part that each part was joined to, or itself
    std::vector<std::map<int, std::int64_t>> mShared; //!< cost of the seams with each neighbour
    std::vector<std::set<int>> mConflicts;
    std::set<std::tuple<std::int64_t, int, int>> mQueue; //!< (-cost, a, b), a < b
};

PartJoiner::PartJoiner(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                       std::vector<int> &part)
    : mPart(part)
{
    const int count = part.empty() ? 0 : 1 + *std::max_element(part.begin(), part.end());
    mJoined.resize(count);
    for (int p = 0; p < count; ++p)
        mJoined[p] = p;
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

void PartJoiner::run()
{
    while (!mQueue.empty()) {
        auto [cost, a, b] = *mQueue.begin();
        mQueue.erase(mQueue.begin());
        if (mConflicts[a].count(b) > 0)
            continue;
        const auto size = [&](int p) { return mShared[p].size() + mConflicts[p].size(); };
        if (size(a) < size(b))
            std::swap(a, b);
        join(a, b);
    }
    for (int &p : mPart)
        p = find(p);
}

void PartJoiner::join(int into, int from)
{
    mJoined[from] = into;
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

int PartJoiner::find(int part)
{
    while (mJoined[part] != part)
        part = mJoined[part] = mJoined[mJoined[part]];
    return part;
}

//! Gives every connected set of units of one part a number of its own: a part may have become disconnected,
//! and its components can then be treated separately.
void relabelPieces(const UnitGraph &graph, std::vector<int> &part)
{
    UnionFind pieces(graph.unitCount);
    for (const UnitGraph::Link &link : graph.links) {
        if (part[link.a] == part[link.b])
            pieces.unite(link.a, link.b);
    }
    part = pieces.labels().first;
}

//! The part to which moving the unit makes the seams cheapest; its own part when no move lowers the cost.
int cheaperPart(const UnitGraph &graph, const std::vector<std::int64_t> &capacity,
                const std::vector<int> &part, int unit)
{
    std::map<int, std::int64_t> joined; // cost of the unit's links to each neighbouring part
    for (int link : graph.linksOfUnit[unit])
        joined[part[graph.across(link, unit)]] += capacity[link];
    const auto conflicts = graph.conflicts[unit];
    int best = part[unit];
    std::int64_t bestCost = joined.count(best) > 0 ? joined[best] : 0;
    for (const auto &[other, cost] : joined) {
        if (cost > bestCost &&
            std::none_of(conflicts.begin(), conflicts.end(), [&](int c) { return part[c] == other; })) {
            best = other;
            bestCost = cost;
        }
    }
    return best;
}

//! Moves single units to neighbouring parts while that lowers the seam cost and creates no overlap. Every
//! move lowers the total cost, an integer, so this ends.
void smoothParts(const UnitGraph &graph, const std::vector<std::int64_t> &capacity, std::vector<int> &part)
{
    std::vector<int> queue;
    std::vector<bool> queued(graph.unitCount, false);
    const auto enqueue = [&](int unit) {
        if (!queued[unit])
            queue.push_back(unit);
        queued[unit] = true;
    };
    for (const UnitGraph::Link &link : graph.links) {
        if (part[link.a] != part[link.b]) {
            enqueue(link.a);
            enqueue(link.b);
        }
    }
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const int unit = queue[head];
        queued[unit] = false;
        const int to = cheaperPart(graph, capacity, part, unit);
        if (to == part[unit])
            continue;
        part[unit] = to;
        for (int neighbour : graph.neighbours[unit])
            enqueue(neighbour);
    }
}

} // namespace

void joinCleanParts(const UnitGraph &graph, const std::vector<std::int64_t> &capacity, std::vector<int> &part)
{
    relabelPieces(graph, part);
    PartJoiner(graph, capacity, part).run();
    smoothParts(graph, capacity, part);
    relabelPieces(graph, part);
    PartJoiner(graph, capacity, part).run();
}

} // namespace autocuts::overlap
