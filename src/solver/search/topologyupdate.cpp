#include "solver/search/topologyupdate.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace autocuts::search {

void TopologyUpdate::update(CutState &state, std::span<const int> opened, std::span<const int> closed)
{
    const SeamGraph &graph = *state.graph;
    const std::vector<EdgePair> &pairs = graph.soup->mesh->edgePairs;
    mSearch.resize(graph.triangleCount(), 0);
    mReached.resize(graph.triangleCount());
    mChartsChanged = mHasSplit = false;
    updateBoundary(state, opened, closed);
    splitCharts(state, opened);
    for (const int e : closed) {
        const auto [a, b] = pairs[e].triangle;
        if (state.chart[a] != state.chart[b])
            joinCharts(state, a, b);
    }
    if (mChartsChanged) {
        numberCharts(state);
        state.countSmallParts();
    }
    state.updateCrooked();
}

void TopologyUpdate::updateBoundary(CutState &state, std::span<const int> opened, std::span<const int> closed)
{
    const SeamGraph &graph = *state.graph;
    const auto sortedSides = [&](std::span<const int> edges) {
        mSides.clear();
        for (const int e : edges) {
            const EdgePair &pair = graph.soup->mesh->edgePairs[e];
            for (int which = 0; which < 2; ++which)
                mSides.push_back(3 * pair.triangle[which] + pair.side(which));
        }
        std::sort(mSides.begin(), mSides.end());
    };
    for (const int e : closed) {
        state.cost -= graph.cost[e];
        state.length -= graph.length[e];
    }
    for (const int e : opened) {
        state.cost += graph.cost[e];
        state.length += graph.length[e];
    }
    mMerged.clear();
    sortedSides(closed);
    std::set_difference(state.boundary.begin(), state.boundary.end(), mSides.begin(), mSides.end(),
                        std::back_inserter(mMerged));
    sortedSides(opened);
    state.boundary.clear();
    std::merge(mMerged.begin(), mMerged.end(), mSides.begin(), mSides.end(),
               std::back_inserter(state.boundary));
}

//! Finds the charts that the opened edges divide.
void TopologyUpdate::splitCharts(CutState &state, std::span<const int> opened)
{
    std::vector<std::pair<int, int>> seeds; // chart and triangle
    for (const int e : opened) {
        for (const int t : state.graph->soup->mesh->edgePairs[e].triangle)
            seeds.emplace_back(state.chart[t], t);
    }
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    std::vector<int> triangles;
    for (std::size_t i = 0; i < seeds.size();) {
        triangles.clear();
        const int chart = seeds[i].first;
        for (; i < seeds.size() && seeds[i].first == chart; ++i)
            triangles.push_back(seeds[i].second);
        splitChart(state, triangles);
    }
}

//! Searches a chart from all seeds at the same time. Fronts that meet go on as one; those that come to an end
//! before they meet the others become charts of their own.
void TopologyUpdate::splitChart(CutState &state, std::span<const int> seeds)
{
    beginSearch();
    for (const int t : seeds)
        addFront(t);
    int open = mFrontsLeft;
    while (mFrontsLeft > 1 && open > 1) {
        open = 0;
        for (int f = 0; f < static_cast<int>(mFronts.size()) && mFrontsLeft > 1; ++f) {
            if (mParent[f] == f && !mFronts[f].isDone())
                advance(state, f);
            open += mParent[f] == f && !mFronts[f].isDone();
        }
    }
    if (mFrontsLeft < 2)
        return;
    // The part that would go on, or the first one, keeps the number.
    int kept = -1;
    for (int f = 0; f < static_cast<int>(mFronts.size()); ++f) {
        if (mParent[f] == f && (kept < 0 || !mFronts[f].isDone()))
            kept = f;
    }
    for (int f = 0; f < static_cast<int>(mFronts.size()); ++f) {
        if (mParent[f] != f || f == kept)
            continue;
        double area = 0;
        const int own = state.chartCount(), whole = state.chart[mFronts[f].triangles.front()];
        for (const int t : mFronts[f].triangles) {
            area += state.graph->soup->shareOfCopy(t);
            state.chart[t] = own;
        }
        state.chartArea.push_back(area);
        state.chartArea[whole] -= area;
        mChartsChanged = mHasSplit = true;
    }
}

//! Joins the charts of two triangles. The smaller one, which a search from both finds, gets the other's
//! number.
void TopologyUpdate::joinCharts(CutState &state, int a, int b)
{
    beginSearch();
    addFront(a);
    addFront(b);
    int f = 0;
    for (; !mFronts[f].isDone(); f = 1 - f)
        advance(state, f);
    const int from = state.chart[f == 0 ? a : b], to = state.chart[f == 0 ? b : a];
    for (const int t : mFronts[f].triangles)
        state.chart[t] = to;
    state.chartArea[to] += state.chartArea[from];
    state.chartArea[from] = -1; // there is none any more
    mChartsChanged = true;
}

//! Numbers the charts by their first triangles, as CutState::updateTopology() does.
void TopologyUpdate::numberCharts(CutState &state)
{
    std::vector<int> number(state.chartCount(), -1);
    std::vector<double> area;
    for (int &chart : state.chart) {
        if (number[chart] < 0) {
            number[chart] = static_cast<int>(area.size());
            area.push_back(state.chartArea[chart]);
        }
        chart = number[chart];
    }
    state.chartArea = std::move(area);
}

void TopologyUpdate::beginSearch()
{
    ++mSearches;
    mFronts.clear();
    mParent.clear();
    mFrontsLeft = 0;
}

int TopologyUpdate::addFront(int triangle)
{
    if (mSearch[triangle] == mSearches)
        return frontOf(triangle);
    const int f = static_cast<int>(mFronts.size());
    mFronts.push_back({{triangle}, 0});
    mParent.push_back(f);
    mSearch[triangle] = mSearches;
    mReached[triangle] = f;
    ++mFrontsLeft;
    return f;
}

int TopologyUpdate::frontOf(int triangle)
{
    int f = mReached[triangle];
    while (mParent[f] != f)
        f = mParent[f] = mParent[mParent[f]];
    return f;
}

//! Looks at the neighbours of one triangle, within its chart.
void TopologyUpdate::advance(const CutState &state, int front)
{
    const int t = mFronts[front].triangles[mFronts[front].next++];
    for (int side = 3 * t; side < 3 * t + 3; ++side) {
        if (state.isCutSide(side))
            continue;
        const int other = state.graph->across[side] / 3;
        if (state.chart[other] != state.chart[t])
            continue;
        if (mSearch[other] != mSearches) {
            mSearch[other] = mSearches;
            mReached[other] = front;
            mFronts[front].triangles.push_back(other);
        } else if (const int met = frontOf(other); met != front) {
            merge(front, met);
        }
    }
}

//! Front b goes on as a part of front a.
void TopologyUpdate::merge(int a, int b)
{
    Front &into = mFronts[a], &from = mFronts[b];
    mParent[b] = a;
    --mFrontsLeft;
    // What has been looked at comes first.
    const auto looked = from.triangles.begin() + static_cast<std::ptrdiff_t>(from.next);
    into.triangles.insert(into.triangles.begin() + static_cast<std::ptrdiff_t>(into.next),
                          from.triangles.begin(), looked);
    into.next += from.next;
    into.triangles.insert(into.triangles.end(), looked, from.triangles.end());
    from = {};
}

} // namespace autocuts::search
