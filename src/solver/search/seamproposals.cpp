// The large moves that SeamSearch proposes at random. Lengths, probabilities and noise were chosen by hand.
#include "solver/search/seamsearch.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

int SeamSearch::randomSeamEdge()
{
    // A random boundary side, again when it is a border or was cut by the user.
    for (int i = 0; i < 20; ++i) {
        const int side = mState.boundary[mRandom.below(static_cast<int>(mState.boundary.size()))];
        const int e = mState.graph->edgeOf[side];
        if (e >= 0 && mState.graph->rule[e] != SeamGraph::Rule::AlwaysCut)
            return e;
    }
    return -1;
}

//! Replaces a window of 2 to 40 edges of a chain by another path between the same ends.
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

//! Closes a chain, or only its end when the chain has a free end. Nothing above 80 edges.
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

//! Closes the end of a chain and connects the remaining part to the seams or the border by another path.
//! Nothing when more than 60 edges would be closed.
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
    // The chain is closed from `middle` on, towards its last or first vertex; the new path starts at
    // `middle`.
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
    // The new path must not meet the chain again, neither the part that stays nor the old end.
    for (const int v : chain.vertices)
        mPaths.block(v);
    change.open = mPaths.find(from, -1, mRandom.uniform(0, 0.4), mRandom, 1.3 * length);
    if (change.open.empty())
        return {};
    return change;
}

//! Opens a seam from a badly distorted vertex to the nearest seam or border, of cost 1.5 at most.
SeamChange SeamSearch::addChange()
{
    SeamChange change;
    const SeamGraph &graph = *mState.graph;
    // Of 60 random triangles, the one with most energy above that of an isometry.
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
    if (graph.border[from] || mState.cutsAt[from] > 0)
        return change;
    mPaths.clear();
    change.open = mPaths.find(from, -1, mRandom.uniform(0, 0.4), mRandom, 1.5);
    return change;
}

std::vector<int> SeamSearch::bestNewSeam(int tries)
{
    const CutState saved = mState;
    std::vector<int> best;
    double most = 0;
    for (int i = 0; i < tries && !stopped(); ++i) {
        const SeamChange change = addChange();
        double length = 0;
        for (const int e : change.open)
            length += mState.graph->length[e];
        if (!(length > 0) ||
            !attempt(Add, change, mediumPatch, trialSteps, -std::numeric_limits<double>::infinity()))
            continue;
        const double gain = (saved.energy - mState.energy) / length;
        if (gain > most) {
            most = gain;
            best = change.open;
        }
        restore(saved);
    }
    return best;
}

} // namespace autocuts::search
