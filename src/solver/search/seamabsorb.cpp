// Joining charts, growing those that are too small, and the mirror images of seam changes.
#include "solver/search/seamsearch.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

namespace autocuts::search {

namespace {

// Chosen by hand.
AUTOCUTS_CONSTANT(int, absorbSteps, 12); // Newton steps per trial
constexpr double grownShare = 1.1;       // area that a chart is grown to, relative to the least allowed area
AUTOCUTS_CONSTANT(int, edgesPerNeighbour, 6); // seam edges per neighbour from which growing is tried, about
constexpr int mostPatch = 3000;               // triangles in the patch of a trial, at most
constexpr double anyGain = -std::numeric_limits<double>::infinity();
//! Energy that a join may cost where rigid regions keep their shape: to lose it costs more.
constexpr double leastRigidGain = -0.02;

//! Energy that joining or growing a small chart may cost, as a negative gain.
double leastGainOf(const SeamGraph &graph)
{
    return graph.rigid ? leastRigidGain : anyGain;
}

bool contains(const std::vector<int> &edges, int e)
{
    return std::find(edges.begin(), edges.end(), e) != edges.end();
}

} // namespace

//! Adds the mirror images of the edges. An edge that would have to be both opened and closed ends up in both
//! lists, and SeamTrial refuses the change.
SeamChange SeamSearch::withMirrorImages(const SeamChange &change, const CutState &state)
{
    const std::vector<int> &mirror = state.graph->mirror;
    SeamChange both = change;
    if (mirror.empty())
        return both;
    for (const int e : change.open) {
        const int m = mirror[e];
        if (m >= 0 && !contains(both.open, m) && (!state.cut[m] || contains(change.close, m)))
            both.open.push_back(m);
    }
    for (const int e : change.close) {
        const int m = mirror[e];
        if (m >= 0 && state.cut[m] && !contains(both.close, m))
            both.close.push_back(m);
    }
    return both;
}

//! The common seam of a chart with each of its neighbours, longest seam first. Edges cut by the user are left
//! out.
std::vector<std::vector<int>> SeamSearch::seamsAround(int chart) const
{
    const SeamGraph &graph = *mState.graph;
    std::map<int, std::pair<double, std::vector<int>>> byNeighbour;
    for (const int side : mState.boundary) {
        const int e = graph.edgeOf[side];
        if (mState.chart[side / 3] != chart || e < 0 || graph.rule[e] == SeamGraph::Rule::AlwaysCut)
            continue;
        const int other = mState.chart[graph.across[side] / 3];
        if (other == chart)
            continue;
        byNeighbour[other].first -= graph.length[e];
        byNeighbour[other].second.push_back(e);
    }
    std::vector<std::pair<double, std::vector<int>>> sorted;
    for (auto &[other, seam] : byNeighbour)
        sorted.push_back(std::move(seam));
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<std::vector<int>> result;
    for (auto &[length, edges] : sorted)
        result.push_back(std::move(edges));
    return result;
}

//! Joins a chart to one of its neighbours: stitches their whole common seam, else a half of it, a quarter ...
bool SeamSearch::absorb(int chart)
{
    const int triangles = static_cast<int>(std::count(mState.chart.begin(), mState.chart.end(), chart));
    Task join{Absorb};
    join.size = std::min(3 * triangles + mediumPatch, mostPatch);
    join.steps = absorbSteps;
    join.minGain = leastGainOf(*mState.graph);
    std::vector<Task> joins;
    for (const std::vector<int> &seam : seamsAround(chart)) {
        for (std::size_t length = seam.size(); length > 0; length /= 2) {
            for (std::size_t first = 0; first + length <= seam.size(); first += length) {
                const auto begin = seam.begin() + static_cast<std::ptrdiff_t>(first);
                join.number = ++mTasks;
                join.change.close.assign(begin, begin + static_cast<std::ptrdiff_t>(length));
                joins.push_back(join);
            }
        }
    }
    for (std::size_t i = 0; i < joins.size(); ++i) {
        if (tryJoin(joins, i))
            return true;
        if (stopped())
            return false;
    }
    return false;
}

//! Tries one of several joins, which are tried one after another.
bool SeamSearch::tryJoin(const std::vector<Task> &joins, std::size_t which)
{
    const auto foresight = [&](std::size_t most) {
        const std::span next = std::span(joins).subspan(which, std::min(most, joins.size() - which));
        return std::vector<Task>(next.begin(), next.end());
    };
    TrialOutcome outcome;
    return tryTask(joins[which], foresight, outcome);
}

//! Triangles of the neighbouring chart next to a seam edge, breadth first, until they and the chart together
//! have grownShare of the least area. Polygons stay whole. Apart from that, all triangles lie on their own
//! side of the line through the edge, because the chart will be put on the other side.
std::vector<int> SeamSearch::regionAcross(int chart, int edge) const
{
    const SeamGraph &graph = *mState.graph;
    const EdgePair &pair = graph.soup->mesh->edgePairs[edge];
    const int there = mState.chart[pair.triangle[0]] == chart ? 1 : 0;
    std::vector<int> region{pair.triangle[there]};
    const int along = 3 * pair.triangle[there] + pair.side(there);
    const Vec2 from = mState.at(along), to = mState.at(along / 3 * 3 + (along + 1) % 3);
    const auto isInFront = [&](int t) {
        const double least = -1e-9 * (to - from).squaredNorm();
        return cross2(from, to, mState.at(3 * t)) >= least &&
               cross2(from, to, mState.at(3 * t + 1)) >= least &&
               cross2(from, to, mState.at(3 * t + 2)) >= least;
    };
    std::set<int> seen(region.begin(), region.end());
    double area = mState.chartArea[chart];
    const auto addNeighbours = [&](int t, bool ofPolygon) {
        for (int side = 3 * t; side < 3 * t + 3; ++side) {
            if (mState.isCutSide(side))
                continue;
            const bool inside = graph.rule[graph.edgeOf[side]] == SeamGraph::Rule::NeverCut;
            const int next = graph.across[side] / 3;
            if (inside == ofPolygon && (inside || isInFront(next)) && seen.insert(next).second)
                region.push_back(next);
        }
    };
    std::size_t whole = 0; // the polygons of this many triangles are complete in the region
    for (std::size_t at = 0; at < region.size(); ++at) {
        for (; whole < region.size(); ++whole) {
            addNeighbours(region[whole], true);
            area += graph.soup->shareOfCopy(region[whole]);
        }
        if (area >= grownShare * CutState::smallestChart(*graph.soup, region.front()))
            break;
        addNeighbours(region[at], false);
    }
    return region;
}

//! Cuts edges that separate charts and moves the charts apart rigidly.
void SeamSearch::cutApart(const std::vector<int> &edges)
{
    mTrial.cutApart(edges);
    mapChanged();
    touchAll();
}

//! Makes a chart large enough: cuts triangles off a neighbour and stitches them to the chart.
bool SeamSearch::grow(int chart)
{
    const int before = mState.smallParts;
    const CutState saved = mState;
    std::vector<int> edges;
    for (const std::vector<int> &seam : seamsAround(chart)) {
        for (std::size_t i = 0; i < seam.size(); i += 1 + seam.size() / edgesPerNeighbour)
            edges.push_back(seam[i]);
    }
    for (const int edge : edges) {
        const std::vector<int> region = regionAcross(chart, edge);
        const std::set<int> inside(region.begin(), region.end());
        SeamChange split, join;
        for (const int t : region) {
            for (int side = 3 * t; side < 3 * t + 3; ++side) {
                const int e = mState.graph->edgeOf[side];
                if (e < 0 || inside.count(mState.graph->across[side] / 3))
                    continue;
                if (!mState.cut[e])
                    split.open.push_back(e);
                else if (mState.chart[mState.graph->across[side] / 3] == chart)
                    join.close.push_back(e);
            }
        }
        cutApart(withMirrorImages(split, mState).open);
        const int size = std::min(3 * static_cast<int>(region.size()) + mediumPatch, mostPatch);
        if ((attempt(Absorb, join, size, absorbSteps, leastGainOf(*mState.graph)) ||
             attempt(Absorb, {{}, {edge}}, size, absorbSteps, leastGainOf(*mState.graph))) &&
            mState.smallParts < before)
            return true;
        restore(saved);
        if (stopped())
            break;
    }
    return false;
}

void SeamSearch::joinCharts()
{
    const SeamGraph &graph = *mState.graph;
    std::set<int> failed; // an edge of each seam that could not be closed
    for (bool again = true; again && !stopped();) {
        again = false;
        std::map<std::pair<int, int>, std::vector<int>> seams;
        for (const int side : mState.boundary) {
            const int e = graph.edgeOf[side];
            const int a = mState.chart[side / 3], b = e < 0 ? -1 : mState.chart[graph.across[side] / 3];
            if (b > a && graph.rule[e] != SeamGraph::Rule::AlwaysCut)
                seams[{a, b}].push_back(e);
        }
        std::vector<std::pair<double, std::vector<int>>> sorted;
        for (auto &[charts, edges] : seams) {
            double length = 0;
            for (const int e : edges)
                length -= graph.cost[e];
            if (!failed.count(edges.front()))
                sorted.emplace_back(length, std::move(edges));
        }
        std::sort(sorted.begin(), sorted.end());
        std::vector<Task> joins;
        for (const auto &[length, edges] : sorted) {
            Task join{Absorb, ++mTasks};
            join.change.close = edges;
            join.size = std::clamp(12 * static_cast<int>(edges.size()), 200, 1000);
            join.steps = absorbSteps;
            joins.push_back(std::move(join));
        }
        for (std::size_t i = 0; i < joins.size(); ++i) {
            if (stopped())
                return;
            if (tryJoin(joins, i))
                again = true;
            else
                failed.insert(joins[i].change.close.front());
        }
    }
}

void SeamSearch::absorbSmallCharts()
{
    std::set<int> failed; // first triangles of the charts that could not be joined or grown
    while (!stopped() && mState.smallParts > 0) {
        std::vector<int> first(mState.chartCount(), -1);
        for (int t = mState.graph->triangleCount() - 1; t >= 0; --t)
            first[mState.chart[t]] = t;
        int smallest = -1;
        for (int c = 0; c < mState.chartCount(); ++c) {
            if (mState.chartArea[c] < CutState::smallestChart(*mState.graph->soup, first[c]) &&
                !failed.count(first[c]) && (smallest < 0 || mState.chartArea[c] < mState.chartArea[smallest]))
                smallest = c;
        }
        if (smallest < 0)
            return;
        if (!absorb(smallest) && !grow(smallest))
            failed.insert(first[smallest]);
    }
}

} // namespace autocuts::search
