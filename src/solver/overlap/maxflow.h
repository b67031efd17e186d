// Minimum cut between two sets of nodes of an undirected graph.
#pragma once

#include <cstdint>
#include <vector>

namespace autocuts::overlap {

//! Undirected graph with integer capacities, so that the computation is exact and ends.
class MaxFlow
{
public:
    explicit MaxFlow(int nodeCount);

    void addEdge(int a, int b, std::int64_t capacity);
    void setSource(int node) { mSide[node] = Source; }
    void setSink(int node) { mSide[node] = Sink; }

    //! Computes the capacity of the minimum cut between all sources and all sinks. Call once.
    std::int64_t run();
    //! After run(): true for nodes on the source's side of a minimum cut; of all minimum cuts the one with
    //! the fewest nodes on that side.
    const std::vector<bool> &sourceSide() const { return mReached; }

private:
    enum Terminal : std::uint8_t { Inner, Source, Sink };
    struct Arc
    {
        int to;
        int reverse; //!< index of the opposite arc
        std::int64_t capacity;
    };
    struct Edge
    {
        int a, b;
        std::int64_t capacity;
    };

    void buildArcs();
    bool findLevels();
    std::int64_t augmentFrom(int source);

    std::vector<Edge> mEdges;
    std::vector<Terminal> mSide;
    std::vector<int> mFirst; //!< first arc of each node
    std::vector<Arc> mArcs;
    std::vector<int> mNext; //!< arc to try next, per node
    std::vector<int> mLevel;
    std::vector<bool> mReached;
};

} // namespace autocuts::overlap
