// The larger changes that a seam search proposes.
#include "solver/search/seamsearch.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

int SeamSearch::randomSeamEdge()
{
    // Boundary sides are cut edges mostly; borders are skipped.
    for (int i = 0; i < 20; ++i) {
        const int side = mState.boundary[mRandom.below(static_cast<int>(mState.boundary.size()))];
        const int e = mState.graph->edgeOf[side];
        if (e >= 0 && mState.graph->rule[e] != SeamGraph::Rule::AlwaysCut)
            return e;
    }
    return -1;
}

//! Another way for a part of a chain.
SeamChange SeamSearch::windowChange()
{
    SeamChange change;
    const int edge = randomSeamEdge();
    if (edge < 0)
        return change;
    const SeamChain chain = chainOf(mState, edge);
    const int n = static_cast<int>(chain.edges.size());
    if (n < 2)
        return change;
    const int place =
        static_cast<int>(std::find(chain.edges.begin(), chain.edges.end(), edge) - chain.edges.begin());
    const int wanted = static_cast<int>(std::round(2 * std::pow(20.0, mRandom.uniform())));
    const int size = std::min(wanted, n);
    const int first = std::clamp(place - mRandom.below(size), 0, n - size);
    const int from = chain.vertices[first], to = chain.vertices[first + size];
    if (from == to)
        return change;
    mPaths.clear();
    double length = 0;
    for (int i = first; i < first + size; ++i) {
        length += mState.graph->cost[chain.edges[i]];
        if (i > first)
            mPaths.allow(chain.vertices[i]);
    }
    const double noise = mRandom.uniform() < 0.3 ? 0 : mRandom.uniform(0, 0.7);
    const std::vector<int> path = mPaths.find(from, to, noise, mRandom, 2 * length);
    if (path.empty())
        return change;
    for (const int e : path) {
        if (!mState.cut[e])
            change.open.push_back(e);
    }
    for (int i = first; i < first + size; ++i) {
        if (std::find(path.begin(), path.end(), chain.edges[i]) == path.end())
            change.close.push_back(chain.edges[i]);
    }
    if (change.open.empty())
        change.close.clear();
    return change;
}

//! A chain, or its end where it ends freely, closed.
SeamChange SeamSearch::removeChange()
{
    SeamChange change;
    const int edge = randomSeamEdge();
    if (edge < 0)
        return change;
    SeamChain chain = chainOf(mState, edge);
    const bool freeFirst = chain.endsFreely(mState, false), freeLast = chain.endsFreely(mState, true);
    const int n = static_cast<int>(chain.edges.size());
    if (!freeFirst && freeLast) {
        std::reverse(chain.edges.begin(), chain.edges.end());
        std::reverse(chain.vertices.begin(), chain.vertices.end());
    }
    const int size = (freeFirst || freeLast) && mRandom.uniform() < 0.6 ? 1 + mRandom.below(n) : n;
    if (size > 80)
        return change;
    change.close.assign(chain.edges.begin(), chain.edges.begin() + size);
    return change;
}

//! The end of a chain stays open and meets the seams elsewhere.
SeamChange SeamSearch::regraftChange()
{
    SeamChange change;
    const int edge = randomSeamEdge();
    if (edge < 0)
        return change;
    const SeamChain chain = chainOf(mState, edge);
    const int n = static_cast<int>(chain.edges.size());
    if (n < 2)
        return change;
    // Closed from `first` on; the new path starts there.
    const bool towardsLast =
        chain.endsFreely(mState, false) || (!chain.endsFreely(mState, true) && mRandom.uniform() < 0.5);
    const int middle = chain.endsFreely(mState, false) || chain.endsFreely(mState, true)
                           ? mRandom.below(n)
                           : 1 + mRandom.below(n - 1);
    mPaths.clear();
    double length = 0;
    if (towardsLast) {
        for (int i = middle; i < n; ++i)
            change.close.push_back(chain.edges[i]);
    } else {
        for (int i = 0; i < n - middle; ++i)
            change.close.push_back(chain.edges[i]);
    }
    if (change.close.size() > 60)
        return {};
    for (const int e : change.close)
        length += mState.graph->cost[e];
    const int from = towardsLast ? chain.vertices[middle] : chain.vertices[n - middle];
    // Not along the part that stays, nor back to where it came from.
    for (const int v : chain.vertices)
        mPaths.block(v);
    change.open = mPaths.find(from, -1, mRandom.uniform(0, 0.4), mRandom, 1.3 * length);
    if (change.open.empty())
        return {};
    return change;
}

//! A new seam from a badly distorted place to the nearest one.
SeamChange SeamSearch::addChange()
{
    SeamChange change;
    const SeamGraph &graph = *mState.graph;
    // The worst of some random triangles, by excess energy.
    int worst = -1;
    double most = 0;
    for (int i = 0; i < 60; ++i) {
        const int t = mRandom.below(graph.triangleCount());
        const double excess = mState.triangleEnergy[t] - 4 * graph.soup->weight[t];
        if (excess > most) {
            most = excess;
            worst = t;
        }
    }
    if (worst < 0)
        return change;
    const int from = graph.vertex[3 * worst + mRandom.below(3)];
    if (graph.border[from] || mState.cutsAt(from) > 0)
        return change;
    mPaths.clear();
    change.open = mPaths.find(from, -1, mRandom.uniform(0, 0.4), mRandom, 1.5);
    return change;
}

} // namespace autocuts::search
