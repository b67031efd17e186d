#include "solver/straight/necks.h"

#include "model/plain/parallel.h"
#include "solver/base/alignedborder.h"
#include "solver/straight/island.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>

namespace autocuts::straight {

namespace {

// Chosen by hand, by looking at maps of machines and vehicles.
constexpr double mostAdded = 0.05;      //!< cost of all necks, as a share of the length of the seams
constexpr double leastGain = 0.1;       //!< of an island's aligned border, beyond what the neck costs
constexpr double leastPart = 0.05;      //!< of an island's border, on each side of a neck
constexpr double longest = 0.6;         //!< neck, as a share of the square root of the island's area
constexpr double inwards = -0.17;       //!< turn of the border where a neck begins, radians
constexpr std::size_t mostStarts = 300; //!< points at which necks of an island are looked for
//! A path through an island.
struct Neck
{
    double cost = 0, gain = 0;
    std::vector<int> edges; //!< edge pairs

    double rate() const { return gain / cost; }
};

//! Looks for the best neck of one island.
class NeckFinder
{
public:
    NeckFinder(const Soup &soup, const Snapshot &snapshot, const CutMesh &charts, const Island &island,
               const std::vector<int> &edgeOfSide)
        : mIsland(island), mWays(island.position.size()), mPlace(island.position.size(), -1)
    {
        for (std::size_t t = 0; t < island.triangles.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                const int side = 3 * island.triangles[t] + k, edge = edgeOfSide[side];
                if (charts.neighbour[side] < 0 || edge < 0)
                    continue;
                const double cost = snapshot.edgeWeight(edge) * soup.pairLength[2 * edge];
                mWays[island.points[t][k]].push_back({island.points[t][(k + 1) % 3], edge, cost});
            }
        }
    }

    std::optional<Neck> best(const JobContext &job)
    {
        for (const Island::Loop &loop : mIsland.loops)
            searchLoop(loop, job);
        return std::move(mBest);
    }

private:
    struct Way
    {
        int to, edge;
        double cost;
    };

    Vec2 side(const Island::Loop &loop, std::size_t i) const
    {
        return mIsland.position[loop.point[(i + 1) % loop.point.size()]] - mIsland.position[loop.point[i]];
    }

    void searchLoop(const Island::Loop &loop, const JobContext &job)
    {
        const std::size_t count = loop.point.size();
        mUpTo.assign(count + 1, {});
        for (std::size_t i = 0; i < count; ++i) {
            mPlace[loop.point[i]] = static_cast<int>(i);
            mUpTo[i + 1] = mUpTo[i];
            mUpTo[i + 1].add(side(loop, i), side(loop, i).norm());
        }
        std::vector<std::size_t> starts(count);
        std::iota(starts.begin(), starts.end(), 0);
        std::stable_sort(starts.begin(), starts.end(),
                         [&](std::size_t a, std::size_t b) { return loop.turn[a] < loop.turn[b]; });
        starts.resize(std::min(count, mostStarts));
        for (const std::size_t start : starts) {
            if (loop.turn[start] > inwards || job.stopped())
                break;
            searchFrom(loop.point[start]);
        }
        for (const int point : loop.point)
            mPlace[point] = -1;
    }

    //! Follows the shortest paths from a point of the border to other points of it.
    void searchFrom(int start)
    {
        const double reach = longest * std::sqrt(mIsland.area());
        std::vector<double> cost(mIsland.position.size(), std::numeric_limits<double>::infinity());
        std::vector<std::array<int, 2>> from(mIsland.position.size()); // the point before, and the edge
        using Entry = std::pair<double, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        cost[start] = 0;
        open.emplace(0, start);
        while (!open.empty()) {
            const auto [here, point] = open.top();
            open.pop();
            if (here > cost[point])
                continue;
            if (point != start && mPlace[point] >= 0) {
                consider(start, point, here, from);
                continue;
            }
            for (const Way &way : mWays[point]) {
                const double there = here + way.cost;
                if (there >= cost[way.to] || there > reach)
                    continue;
                cost[way.to] = there;
                from[way.to] = {point, way.edge};
                open.emplace(there, way.to);
            }
        }
    }

    void consider(int start, int end, double cost, const std::vector<std::array<int, 2>> &from)
    {
        const auto [low, high] = std::minmax(mPlace[start], mPlace[end]);
        const double whole = mUpTo.back().length(), part = mUpTo[high].length() - mUpTo[low].length();
        if (std::min(part, whole - part) < leastPart * whole || cost <= 0)
            return;
        const AlignedBorder between = mUpTo[high].without(mUpTo[low]), rest = mUpTo.back().without(between);
        const double before = mUpTo.back().most(), gain = between.most() + rest.most() - before;
        if (gain - cost < leastGain * before || (mBest && gain / cost <= mBest->rate()))
            return;
        mBest = Neck{cost, gain, {}};
        for (int point = end; point != start; point = from[point][0])
            mBest->edges.push_back(from[point][1]);
    }

    const Island &mIsland;
    std::vector<std::vector<Way>> mWays; //!< per point: along edges inside the island
    std::vector<int> mPlace;             //!< per point: place in the loop that is searched, -1: not in it
    std::vector<AlignedBorder> mUpTo;    //!< the sides of the loop before a place
    std::optional<Neck> mBest;
};

//! Per triangle side: its edge pair where it may be cut, else -1.
std::vector<int> edgesThatMayBeCut(const Soup &soup, const Snapshot &snapshot)
{
    const std::vector<EdgePair> &pairs = soup.mesh->edgePairs;
    std::vector<int> edgeOfSide(soup.mesh->soupCornerCount(), -1);
    for (std::size_t e = 0; e < pairs.size(); ++e) {
        for (int which = 0; which < 2 && !pairs[e].diagonal && !snapshot.isJoined(e); ++which)
            edgeOfSide[3 * pairs[e].triangle[which] + pairs[e].side(which)] = static_cast<int>(e);
    }
    return edgeOfSide;
}

} // namespace

bool cutNecks(const Soup &soup, const Snapshot &snapshot, const std::vector<bool> &aligned, SeamedMap &map,
              const JobContext &job)
{
    const SolveSettings &settings = snapshot.settings;
    if (settings.seams != SeamMode::Free || settings.symmetry == SymmetryMode::On || settings.mirrorMaps)
        return false;
    const std::vector<int> edgeOfSide = edgesThatMayBeCut(soup, snapshot);
    double budget = mostAdded * map.seamLength(soup);
    std::vector<bool> settled(soup.triangleCount(), false); // at the first triangle of an island
    bool anyCut = false;
    // Each round cuts every island once at most.
    for (bool again = true; again && !job.stopped();) {
        const CutMesh charts(*soup.mesh, map.cut);
        const std::vector<bool> held = heldCharts(snapshot, charts);
        const std::vector<Island> islands = islandsOf(soup, charts, map.x);
        std::vector<std::optional<Neck>> necks(islands.size());
        parallelFor(static_cast<int>(islands.size()), job.threads(), [&](int i) {
            const int first = islands[i].triangles.front();
            if (!settled[first] && aligned[soup.mesh->component[first]] && (held.empty() || !held[i]))
                necks[i] = NeckFinder(soup, snapshot, charts, islands[i], edgeOfSide).best(job);
        });
        std::vector<int> order;
        for (int i = 0; i < static_cast<int>(islands.size()); ++i) {
            if (necks[i])
                order.push_back(i);
            else
                settled[islands[i].triangles.front()] = true;
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return necks[a]->rate() > necks[b]->rate(); });
        again = false;
        for (const int i : order) {
            if (necks[i]->cost > budget) {
                settled[islands[i].triangles.front()] = true;
                continue;
            }
            budget -= necks[i]->cost;
            for (const int edge : necks[i]->edges)
                map.cut[edge] = true;
            again = anyCut = true;
        }
    }
    return anyCut;
}

} // namespace autocuts::straight
