// Minimum cut between two sets of nodes of an undirected graph.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace autocuts::overlap {

//! Undirected graph with integer capacities, so that the computation is exact and ends. It visits the nodes
//! around the sources and sinks only, as far as it takes to find a side of the cut.
class MaxFlow
{
public:
    //! Of several minimum cuts the one that is found.
    enum class Tie {
        FewestAtSources, //!< the one with the fewest nodes on the side of the sources
        Quickest         //!< also the one with the fewest nodes on the side of the sinks
    };

    explicit MaxFlow(int nodeCount);

    //! \pre run() was not called yet
    void addEdge(int a, int b, std::int64_t capacity);
    void setSource(int node) { setTerminal(node, Sources); }
    void setSink(int node) { setTerminal(node, Sinks); }

    //! Computes the capacity of the minimum cut between all sources and all sinks.
    std::int64_t run(Tie tie = Tie::FewestAtSources);

    // After run():

    //! The nodes on one side of the cut; with FewestAtSources that of the sources.
    const std::vector<int> &side() const { return mReached[mFound]; }
    //! Per node: true on the side of the sources.
    std::vector<bool> sourceSide() const;
    //! Nodes visited by all runs, each as often as it was visited.
    std::int64_t visits() const;
    //! Removes the edges of the cut, then all sources and sinks, for another run.
    void removeCut();

private:
    enum End : std::uint8_t { Sources, Sinks, Inner };
    struct Arc
    {
        int to;
        int reverse; //!< index of the opposite arc
        std::int64_t capacity, unused;
    };
    struct Edge
    {
        int a, b;
        std::int64_t capacity;
    };

    void setTerminal(int node, End end);
    void buildArcs();
    bool findLevels(Tie tie);
    bool growFrom(End end, std::size_t &head);
    void forgetLevels();
    std::int64_t augmentFrom(int source);

    std::vector<Edge> mEdges;
    std::vector<End> mEnd;
    std::array<std::vector<int>, 2> mTerminals; //!< sources and sinks
    std::vector<int> mFirst;                    //!< first arc of each node
    std::vector<Arc> mArcs;
    std::vector<int> mChanged; //!< arcs with flow
    std::vector<int> mNext;    //!< arc to try next, per node
    //! Per node: steps from the sources and to the sinks along arcs with unused capacity; -1 where not
    //! reached.
    std::array<std::vector<int>, 2> mSteps;
    std::array<std::vector<int>, 2> mReached; //!< the nodes that have these, in that order
    End mFound = Sources;
    std::int64_t mVisits = 0; //!< in searches that are over
};

} // namespace autocuts::overlap
