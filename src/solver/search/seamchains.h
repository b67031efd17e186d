// Seams as chains between branch points, and shortest ways for new ones.
#pragma once

#include "solver/base/random.h"
#include "solver/search/cutstate.h"

#include <queue>
#include <vector>

namespace autocuts::search {

//! Cut edges in a row between two points where seams end, branch or meet a border; or a closed ring.
struct SeamChain
{
    std::vector<int> edges;
    std::vector<int> vertices; //!< one more than edges, in order; first and last are equal for a ring

    //! True when the seam ends freely at its first or last point.
    bool endsFreely(const CutState &state, bool last) const;
};

//! The chain that an edge belongs to. \pre it is cut
SeamChain chainOf(const CutState &state, int edge);

//! Shortest paths along edges by cost; keeps its memory.
class SeamPaths
{
public:
    explicit SeamPaths(const CutState &state);

    //! Marks points where a path may not pass nor end, until clear().
    void block(int v) { mBlocked[v] = mRound; }
    //! Marks points that are no obstacle though seams run through them, until clear().
    void allow(int v) { mAllowed[v] = mRound; }
    void clear() { ++mRound; }

    //! Edges of the shortest path from `from` to `to` (or, with to = -1, to the nearest point on a seam or
    //! border that is not blocked) that touches no seam and no border on its way; empty when there is none or
    //! it is longer than `longest`. \param noise spread of the random factors on the costs
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
