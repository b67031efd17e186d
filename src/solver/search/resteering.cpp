#include "solver/search/resteering.h"

#include "solver/base/rigidfit.h"
#include "solver/search/anchoring.h"
#include "solver/search/seamtrial.h"

#include <algorithm>
#include <set>

namespace autocuts::search {

namespace {

// Chosen by hand.
constexpr std::size_t edgesAtOnce = 24; // opened in one trial, at most
constexpr int trianglesPerEdge = 12;    // of the patch of a trial
constexpr int smallestPatch = 200, largestPatch = 3000;
constexpr int steps = 10;             // Newton steps per trial
constexpr double regionShare = 0.006; // of the mesh's area that is first cut off to close edges, about

class Resteering
{
public:
    Resteering(CutState &state, const JobContext &job) : mState(state), mTrial(state), mJob(job) {}

    void openCuts()
    {
        std::vector<int> edges;
        for (std::size_t e = 0; e < mState.cut.size(); ++e) {
            if (graph().rule[e] == SeamGraph::Rule::AlwaysCut && !mState.cut[e])
                edges.push_back(static_cast<int>(e));
        }
        for (const std::vector<int> &group : connected(edges)) {
            for (std::size_t first = 0; first < group.size() && !mJob.stopped(); first += edgesAtOnce) {
                const auto begin = group.begin() + static_cast<std::ptrdiff_t>(first);
                open({begin,
                      begin + static_cast<std::ptrdiff_t>(std::min(edgesAtOnce, group.size() - first))});
            }
        }
    }

    bool closeJoins()
    {
        std::vector<int> edges;
        for (std::size_t e = 0; e < mState.cut.size(); ++e) {
            if (graph().rule[e] == SeamGraph::Rule::NeverCut && mState.cut[e])
                edges.push_back(static_cast<int>(e));
        }
        for (const std::vector<int> &group : connected(edges)) {
            if (!close(group))
                return false;
        }
        return true;
    }

    void anchor()
    {
        if (graph().anchors.empty())
            return;
        if (!mState.anchored) {
            placeAtAnchors(mState);
            mTrial.reset();
        }
        reachPins(mTrial, true);
    }

private:
    const SeamGraph &graph() const { return *mState.graph; }

    //! Groups of edges that are connected by their ends, each in the order of a walk from edge to edge.
    std::vector<std::vector<int>> connected(const std::vector<int> &edges) const
    {
        std::set<int> left(edges.begin(), edges.end());
        std::vector<std::vector<int>> groups;
        while (!left.empty()) {
            std::vector<int> group{*left.begin()};
            left.erase(left.begin());
            for (std::size_t at = 0; at < group.size(); ++at) {
                for (const int v : graph().ends[group[at]]) {
                    for (const int e : graph().edgesAt(v)) {
                        if (left.erase(e) > 0)
                            group.push_back(e);
                    }
                }
            }
            groups.push_back(std::move(group));
        }
        return groups;
    }

    bool attempt(const SeamChange &change, std::size_t patchSize)
    {
        TrialTerms terms;
        terms.patchSize = std::clamp(static_cast<int>(patchSize), smallestPatch, largestPatch);
        terms.steps = steps;
        terms.minGain = -std::numeric_limits<double>::infinity();
        return mTrial.attempt(change, terms);
    }

    //! Opens edges and lets the map around them relax; where that is not possible, the two sides of the edges
    //! stay in one place.
    void open(const std::vector<int> &edges)
    {
        if (attempt({edges, {}}, trianglesPerEdge * edges.size()))
            return;
        for (const int e : edges)
            mState.cut[e] = 1;
        update();
    }

    //! After a change of the cut flags.
    void update()
    {
        const int before = mState.chartCount();
        mState.updateTopology();
        if (mState.chartCount() > before)
            mState.spreadCharts();
        mTrial.reset();
    }

    void restore(const CutState &state)
    {
        mState = state;
        mTrial.reset();
    }

    //! Closes edges: as they are; after moving one chart to the other; with the triangles on one side, or on
    //! both, cut off their chart. Else one half of the edges after the other.
    bool close(std::vector<int> edges)
    {
        std::erase_if(edges, [this](int e) { return !mState.cut[e]; });
        if (edges.empty())
            return true;
        if (mJob.stopped())
            return false;
        if (attempt({{}, edges}, trianglesPerEdge * edges.size()) || closeByMovingChart(edges))
            return true;
        for (const double share : {regionShare, 0.0}) {
            if (closeByRegion(edges, {0}, share) || closeByRegion(edges, {1}, share))
                return true;
        }
        if (closeByRegion(edges, {0, 1}, 0))
            return true;
        if (edges.size() == 1)
            return false;
        const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
        return close({edges.begin(), middle}) && close({middle, edges.end()});
    }

    //! Moves the smaller one of two charts to the other one and closes the edges between them.
    bool closeByMovingChart(const std::vector<int> &edges)
    {
        const MeshData &mesh = *graph().soup->mesh;
        std::array<int, 2> charts{};
        for (int which = 0; which < 2; ++which)
            charts[which] = mState.chart[mesh.edgePairs[edges.front()].triangle[which]];
        if (charts[0] == charts[1])
            return false;
        std::array<bool, 2> held{};
        for (int t = 0; t < graph().triangleCount(); ++t) {
            for (int which = 0; which < 2; ++which)
                held[which] = held[which] || (mState.chart[t] == charts[which] && mState.isAnchored(t));
        }
        if (held[0] && held[1])
            return false;
        const bool firstMoves =
            held[0] != held[1] ? held[1] : mState.chartArea[charts[0]] < mState.chartArea[charts[1]];
        const int moving = charts[firstMoves ? 0 : 1], fixed = charts[firstMoves ? 1 : 0];
        std::vector<PointMatch> matches;
        for (const int e : edges) {
            const EdgePair &pair = mesh.edgePairs[e];
            for (int which = 0; which < 2; ++which) {
                if (mState.chart[pair.triangle[which]] != moving ||
                    mState.chart[pair.triangle[1 - which]] != fixed)
                    continue;
                for (int end = 0; end < 2; ++end)
                    matches.push_back(
                        {mState.at(pair.corner[end][1 - which]), mState.at(pair.corner[end][which])});
            }
        }
        if (matches.empty())
            return false;
        const CutState saved = mState;
        const RigidMotion motion = fitRigid(matches);
        for (int c = 0; c < 3 * graph().triangleCount(); ++c) {
            if (mState.chart[c / 3] == moving)
                cornerAt(mState.x, c) = motion(mState.at(c));
        }
        mState.chartsAreApart = false;
        mTrial.reset();
        if (attempt({{}, edges}, trianglesPerEdge * edges.size()) && !mState.boundariesOverlap())
            return true;
        restore(saved);
        return false;
    }

    //! Cuts the triangles on some sides of the edges off their chart and closes the edges.
    bool closeByRegion(const std::vector<int> &edges, const std::vector<int> &sides, double share)
    {
        const std::set<int> region = regionAt(edges, sides, share);
        const CutState saved = mState;
        for (const int t : region) {
            for (int s = 3 * t; s < 3 * t + 3; ++s) {
                const int e = graph().edgeOf[s];
                if (e >= 0 && !region.count(graph().across[s] / 3))
                    mState.cut[e] = 1;
            }
        }
        update();
        const std::size_t size = 3 * region.size() + trianglesPerEdge * edges.size();
        if (attempt({{}, edges}, size) && !mState.boundariesOverlap())
            return true;
        restore(saved);
        return false;
    }

    //! The triangles at the edges, with all that joins and polygons hold together with them, and others
    //! around them until the region has a share of the mesh's area. \param sides 0, 1: which triangles of an
    //! edge pair
    std::set<int> regionAt(const std::vector<int> &edges, const std::vector<int> &sides, double share) const
    {
        std::vector<int> list;
        std::set<int> region;
        double area = 0;
        const auto add = [&](int t) {
            if (region.insert(t).second) {
                list.push_back(t);
                area += graph().soup->weight[t];
            }
        };
        for (const int e : edges) {
            for (const int side : sides)
                add(graph().soup->mesh->edgePairs[e].triangle[side]);
        }
        for (const double limit : {0.0, share}) {
            // First what has to stay together, then neighbours.
            for (std::size_t at = 0; at < list.size(); ++at) {
                for (int s = 3 * list[at]; s < 3 * list[at] + 3; ++s) {
                    if (mState.isCutSide(s))
                        continue;
                    const bool together = graph().rule[graph().edgeOf[s]] == SeamGraph::Rule::NeverCut;
                    if (together || area < limit)
                        add(graph().across[s] / 3);
                }
            }
        }
        return region;
    }

    CutState &mState;
    SeamTrial mTrial;
    const JobContext &mJob;
};

} // namespace

std::optional<CutState> resteered(const CutState &map, std::shared_ptr<const SeamGraph> graph,
                                  const JobContext &job)
{
    CutState state = map;
    state.graph = std::move(graph);
    if (state.graph->anchors.all() != map.graph->anchors.all()) {
        state.anchored = state.chartsMayMeet = state.chartsAreApart = false;
        state.pinStiffness = 1;
        state.pinReached.assign(state.graph->anchors.all().size(), 0);
    }
    state.updateTopology();
    state.updateEnergy();
    Resteering change(state, job);
    change.openCuts();
    if (!change.closeJoins())
        return std::nullopt;
    change.anchor();
    return state;
}

} // namespace autocuts::search
