#include "solver/search/seamchains.h"

#include "model/plain/nearestfirst.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::search {

namespace {

bool isNode(const CutState &state, int v)
{
    return state.graph->border[v] || state.cutsAt[v] != 2;
}

//! Appends edges at the end of the chain until it reaches a node or its own first edge.
void extend(const CutState &state, SeamChain &chain)
{
    const SeamGraph &graph = *state.graph;
    while (!isNode(state, chain.vertices.back())) {
        const int v = chain.vertices.back();
        int next = -1;
        for (const int e : graph.edgesAt(v)) {
            if (state.cut[e] && e != chain.edges.back())
                next = e;
        }
        if (next < 0 || next == chain.edges.front())
            return;
        chain.edges.push_back(next);
        chain.vertices.push_back(graph.farEnd(next, v));
    }
}

} // namespace

bool SeamChain::endsFreely(const CutState &state, bool last) const
{
    const int v = last ? vertices.back() : vertices.front();
    return !state.graph->border[v] && state.cutsAt[v] == 1;
}

SeamChain chainOf(const CutState &state, int edge)
{
    const auto [a, b] = state.graph->ends[edge];
    SeamChain chain{{edge}, {b, a}};
    extend(state, chain);
    if (chain.vertices.back() == b && chain.edges.size() > 1 && !isNode(state, b))
        return chain; // a ring
    std::reverse(chain.edges.begin(), chain.edges.end());
    std::reverse(chain.vertices.begin(), chain.vertices.end());
    extend(state, chain);
    return chain;
}

SeamPaths::SeamPaths(const CutState &state)
    : mState(state), mBlocked(state.graph->vertexCount, 0), mAllowed(state.graph->vertexCount, 0),
      mDistance(state.graph->vertexCount, 0), mVia(state.graph->vertexCount, -1),
      mSeen(state.graph->vertexCount, 0)
{}

std::vector<int> SeamPaths::find(int from, int to, double noise, Random &random, double longest)
{
    const SeamGraph &graph = *mState.graph;
    const auto isSeam = [&](int v) {
        return mAllowed[v] != mRound && (graph.border[v] || mState.cutsAt[v] > 0);
    };
    NearestFirst queue(mDistance);
    const auto reach = [&](int v, double distance, int edge) {
        if (mSeen[v] != mSearch)
            mDistance[v] = std::numeric_limits<double>::infinity();
        mSeen[v] = mSearch;
        if (queue.reach(v, distance))
            mVia[v] = edge;
    };
    ++mSearch;
    reach(from, 0, -1);
    int reached = -1;
    for (int v = queue.next(); v >= 0; v = queue.next()) {
        if (mDistance[v] > longest)
            return {};
        if (v != from && (v == to || (to < 0 && isSeam(v)))) {
            reached = v;
            break;
        }
        if (v != from && isSeam(v))
            continue;
        for (const int e : graph.edgesAt(v)) {
            const int w = graph.farEnd(e, v);
            if (graph.rule[e] == SeamGraph::Rule::NeverCut || mBlocked[w] == mRound ||
                (to >= 0 && w != to && isSeam(w)))
                continue;
            const double factor = noise > 0 ? std::exp(noise * random.uniform(-1, 1)) : 1;
            reach(w, mDistance[v] + factor * graph.cost[e], e);
        }
    }
    std::vector<int> path;
    for (int v = reached; v >= 0 && v != from; v = graph.farEnd(mVia[v], v))
        path.push_back(mVia[v]);
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace autocuts::search
