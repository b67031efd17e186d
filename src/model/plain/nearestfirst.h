// The queue of Dijkstra's search for shortest paths. Plain: no Qt.
#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace autocuts {

//! Gives the nodes of a graph that have been reached, the nearest first; of equally near ones, that with the
//! lowest number.
class NearestFirst
{
public:
    //! \param distance per node: of the shortest way so far; infinite where there is none
    explicit NearestFirst(std::vector<double> &distance) : mDistance(distance) {}

    //! Takes a way to a node. \returns true when it is shorter than the shortest so far
    bool reach(int node, double distance)
    {
        if (!(distance < mDistance[node]))
            return false;
        mDistance[node] = distance;
        mQueue.emplace(distance, node);
        return true;
    }
    //! The nearest node that has not been given with its distance; -1: none is left.
    int next()
    {
        while (!mQueue.empty()) {
            const auto [distance, node] = mQueue.top();
            mQueue.pop();
            if (!(distance > mDistance[node]))
                return node;
        }
        return -1;
    }

private:
    using Entry = std::pair<double, int>;
    std::vector<double> &mDistance;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> mQueue;
};

} // namespace autocuts
