#include "solver/search/seamnecks.h"

#include "solver/base/alignedborder.h"
#include "solver/search/shortestpaths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace autocuts::search {

namespace {

// Chosen by hand, by looking at maps of machines and vehicles.
constexpr double inwards = -0.17;       //!< turn of the border where a neck begins, radians
constexpr std::size_t mostStarts = 300; //!< points at which necks of a loop are looked for

//! The angle of a triangle in the map at a corner.
double angleAt(const CutState &state, int corner)
{
    const Vec2 here = state.at(corner), a = state.at(nextSide(corner)) - here,
               b = state.at(sideBefore(corner)) - here;
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

class NeckFinder
{
public:
    NeckFinder(const CutState &state, const std::vector<int> &loop)
        : mState(state), mLoop(loop), mPaths(*state.graph, state.graph->cost), mUpTo(loop.size() + 1)
    {
        const Soup &soup = *state.graph->soup;
        const int copies = soup.mesh->copiesOf(loop.front() / 3);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            mPlace[loop[i]] = i;
            mUpTo[i + 1] = mUpTo[i];
            mUpTo[i + 1].add(state.at(nextSide(loop[i])) - state.at(loop[i]),
                             soup.perCopy * copies * sideLength(loop[i]));
        }
        mReach = alignmentCost * (whole().length() - whole().most());
    }

    std::vector<Neck> all(const JobContext &job)
    {
        std::vector<double> turn;
        for (const int side : mLoop)
            turn.push_back(turnAt(side));
        std::vector<std::size_t> starts(mLoop.size());
        std::iota(starts.begin(), starts.end(), 0);
        std::stable_sort(starts.begin(), starts.end(),
                         [&](std::size_t a, std::size_t b) { return turn[a] < turn[b]; });
        starts.resize(std::min(starts.size(), mostStarts));
        std::vector<Neck> necks;
        for (const std::size_t start : starts) {
            if (turn[start] > inwards || job.stopped())
                break;
            if (std::optional<Neck> neck = bestFrom(start))
                necks.push_back(std::move(*neck));
        }
        std::stable_sort(necks.begin(), necks.end(),
                         [](const Neck &a, const Neck &b) { return a.gain > b.gain; });
        return necks;
    }

private:
    const AlignedBorder &whole() const { return mUpTo.back(); }

    double sideLength(int side) const
    {
        const std::array<double, 6> &shape = mState.graph->soup->restShape[side / 3];
        const int k = side % 3, next = (k + 1) % 3;
        return std::hypot(shape[2 * next] - shape[2 * k], shape[2 * next + 1] - shape[2 * k + 1]);
    }

    //! How much the border turns in the map at the start of a side; positive to the left.
    double turnAt(int side) const
    {
        double angle = angleAt(mState, side);
        while (!mState.isCutSide(sideBefore(side))) {
            side = mState.graph->across[sideBefore(side)];
            angle += angleAt(mState, side);
        }
        return std::numbers::pi - angle;
    }

    //! The edges that lead inwards from the start of a side.
    std::vector<int> edgesInwards(int side) const
    {
        std::vector<int> edges;
        while (!mState.isCutSide(sideBefore(side))) {
            edges.push_back(mState.graph->edgeOf[sideBefore(side)]);
            side = mState.graph->across[sideBefore(side)];
        }
        return edges;
    }

    //! The place in the loop that an edge inside the island reaches at a vertex; none: on another loop.
    std::optional<std::size_t> placeReached(int edge, int vertex) const
    {
        const EdgePair &pair = mState.graph->soup->mesh->edgePairs[edge];
        int side = 3 * pair.triangle[0] + pair.side(0);
        if (mState.graph->vertex[side] != vertex)
            side = mState.graph->across[side];
        while (!mState.isCutSide(side))
            side = nextSide(mState.graph->across[side]);
        const auto found = mPlace.find(side);
        return found == mPlace.end() ? std::nullopt : std::optional(found->second);
    }

    std::optional<Neck> bestFrom(std::size_t start)
    {
        const SeamGraph &graph = *mState.graph;
        const int from = graph.vertex[mLoop[start]];
        const std::vector<int> first = edgesInwards(mLoop[start]);
        std::optional<Neck> best;
        mPaths.run(
            {from}, Way::Any,
            [&](int e, int v) {
                if (mState.cut[e])
                    return false;
                return v == from ? std::find(first.begin(), first.end(), e) != first.end()
                                 : !mState.isBoundaryVertex(v);
            },
            [&](int v) {
                const double cost = mPaths.distance(v);
                if (v == from || cost > mReach || !mState.isBoundaryVertex(v))
                    return cost > mReach;
                const std::optional<std::size_t> end = placeReached(mPaths.lastEdge(v), v);
                const double gain = end ? gainOf(start, *end) - cost : 0;
                if (gain > (best ? best->gain : 0))
                    best = Neck{mPaths.pathTo(v), gain};
                return false;
            });
        return best;
    }

    double gainOf(std::size_t start, std::size_t end) const
    {
        const auto [low, high] = std::minmax(start, end);
        const AlignedBorder between = mUpTo[high].without(mUpTo[low]), rest = whole().without(between);
        return alignmentCost * (between.most() + rest.most() - whole().most());
    }

    const CutState &mState;
    const std::vector<int> &mLoop;
    ShortestPaths mPaths;
    std::unordered_map<int, std::size_t> mPlace; //!< per side of the loop: its place
    std::vector<AlignedBorder> mUpTo;            //!< the sides of the loop before a place
    double mReach;                               //!< cost of a neck, at most
};

} // namespace

std::vector<Neck> necksOf(const CutState &state, const std::vector<int> &loop, const JobContext &job)
{
    return NeckFinder(state, loop).all(job);
}

} // namespace autocuts::search
