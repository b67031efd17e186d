// Seams as chains of edges between branch points, and shortest paths for new seams.
#pragma once

#include "solver/base/random.h"
#include "solver/search/cutstate.h"

#include <queue>
#include <vector>

namespace autocuts::search {

//! A chain of cut edges between two vertices where seams end, branch or meet a border; or a closed ring.
struct SeamChain
{
    std::vector<int> edges;
    std::vector<int> vertices; //!< of the uncut surface, one more than edges; first and last equal for a ring

    //! True when the seam has a free end inside the surface at its first or last vertex.
    bool endsFreely(const CutState &state, bool last) const;
};

//! The chain that a cut edge belongs to. \pre the edge is cut
SeamChain chainOf(const CutState &state, int edge);

//! Shortest paths along edges by SeamGraph::cost (Dijkstra). Reuses its buffers.
class SeamPaths
{
public:
    explicit SeamPaths(const CutState &state);

    //! Forbids paths to pass or end at vertex v, until clear().
    void block(int v) { mBlocked[v] = mRound; }
    //! Lets paths pass vertex v even when it lies on a seam or border, until clear().
    void allow(int v) { mAllowed[v] = mRound; }
    //! Forgets all calls of block() and allow().
    void clear() { ++mRound; }

    //! Shortest path between two vertices that touches no seam or border between its ends.
    //! \param to -1: the nearest vertex on a seam or border that is not blocked
    //! \param noise every edge cost is multiplied by exp(noise * r), r uniform in [-1, 1]
    //! \param longest cost of the path at most
    //! \returns the edges in order; empty when there is no such path
    std::vector<int> find(int from, int to, double noise, Random &random, double longest);

private:
    const CutState &mState;
    std::vector<int> mBlocked, mAllowed;
    int mRound = 1;
    std::vector<double> mDistance;
    std::vector<int> mVia, mSeen;
    int mSearch = 0;
};

} // namespace autocuts::search
