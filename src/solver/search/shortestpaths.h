// Shortest paths along the edges of a mesh.
#pragma once

#include "model/plain/nearestfirst.h"
#include "solver/search/seamgraph.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace autocuts::search {

//! Where a path may run on a mirrored mesh: anywhere, on one side of the plane of symmetry (only its ends may
//! lie on the plane), or within the plane.
enum class Way { Any, OneSide, AlongPlane };

//! True when a path that has reached vertex v may continue along edge e.
inline bool mayTake(const SeamGraph &graph, Way way, int e, int v, bool isStart)
{
    if (graph.rule[e] == SeamGraph::Rule::NeverCut)
        return false;
    if (way == Way::Any)
        return true;
    const bool onPlane = graph.onPlane[graph.ends[e][0]] && graph.onPlane[graph.ends[e][1]];
    if (way == Way::AlongPlane)
        return onPlane;
    return (isStart || !graph.onPlane[v]) && (onPlane || graph.mirror[e] != e);
}

//! Shortest paths over a graph, one search after another.
class ShortestPaths
{
public:
    ShortestPaths(const SeamGraph &graph, const std::vector<double> &cost)
        : mGraph(graph), mCost(cost), mDistance(graph.vertexCount, unreached), mVia(graph.vertexCount, -1)
    {}

    //! Finds the paths from the nearest of some vertices, along edges that are not joined by the user and
    //! that a test lets pass, given the edge and the vertex it is entered from. Ends at the first vertex at
    //! which a second test says so. \returns that vertex; -1: none
    template <typename MayPass, typename EndsAt>
    int run(const std::vector<int> &from, Way way, MayPass mayPass, EndsAt endsAt)
    {
        for (const int v : mReached) {
            mDistance[v] = unreached;
            mVia[v] = -1;
        }
        mReached.clear();
        NearestFirst queue(mDistance);
        const auto reach = [&](int v, double there, int edge) {
            const bool isNew = mDistance[v] == unreached;
            if (!queue.reach(v, there))
                return;
            if (isNew)
                mReached.push_back(v);
            mVia[v] = edge;
        };
        for (const int v : from)
            reach(v, 0, -1);
        for (int v = queue.next(); v >= 0; v = queue.next()) {
            if (endsAt(v))
                return v;
            for (const int e : mGraph.edgesAt(v)) {
                if (mayTake(mGraph, way, e, v, mDistance[v] == 0) && mayPass(e, v))
                    reach(mGraph.farEnd(e, v), mDistance[v] + mCost[e], e);
            }
        }
        return -1;
    }
    //! Finds all paths.
    void run(const std::vector<int> &from, Way way = Way::Any)
    {
        run(
            from, way, [](int, int) { return true; }, [](int) { return false; });
    }

    //! The vertices that can be reached, in ascending order.
    std::vector<int> reached() const
    {
        std::vector<int> sorted = mReached;
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    }
    //! Of the reached vertices, the one that is farthest away. \pre there is one
    int farthest() const
    {
        return *std::max_element(mReached.begin(), mReached.end(), [this](int a, int b) {
            return mDistance[a] != mDistance[b] ? mDistance[a] < mDistance[b] : a > b;
        });
    }
    //! Cost of the path that ends at v. \pre v has been reached
    double distance(int v) const { return mDistance[v]; }
    //! The last edge of the path that ends at v; -1: v is a start.
    int lastEdge(int v) const { return mVia[v]; }
    //! The edges of the path that ends at v, the last one first.
    std::vector<int> pathTo(int v) const
    {
        std::vector<int> edges;
        for (; mVia[v] >= 0; v = mGraph.farEnd(mVia[v], v))
            edges.push_back(mVia[v]);
        return edges;
    }
    //! Cuts the path that ends at v. \returns its number of edges
    int cutPath(int v, CutFlags &cut) const
    {
        const std::vector<int> edges = pathTo(v);
        for (const int e : edges)
            cut[e] = true;
        return static_cast<int>(edges.size());
    }

private:
    static constexpr double unreached = std::numeric_limits<double>::infinity();

    const SeamGraph &mGraph;
    const std::vector<double> &mCost;
    std::vector<double> mDistance; //!< per vertex
    std::vector<int> mVia;         //!< per vertex: the last edge of its path, -1 without one
    std::vector<int> mReached;     //!< vertices
};

} // namespace autocuts::search
