#include "solver/search/seamgraph.h"

#include "solver/linear/cholmodsolver.h"

#include <algorithm>

namespace autocuts::search {

namespace {

SeamGraph::Rule ruleOf(const Snapshot &snapshot, std::size_t e)
{
    if (snapshot.mesh->edgePairs[e].diagonal)
        return SeamGraph::Rule::NeverCut;
    const SeamGraph::Rule otherwise =
        snapshot.rigid && !snapshot.rigid->apart.empty() && snapshot.rigid->apart[e]
            ? SeamGraph::Rule::AlwaysCut
            : SeamGraph::Rule::Free;
    if (snapshot.steering->pairState.empty())
        return otherwise;
    const PairState a = snapshot.steering->pairState[2 * e], b = snapshot.steering->pairState[2 * e + 1];
    if (a == PairState::Cut || b == PairState::Cut)
        return SeamGraph::Rule::AlwaysCut;
    return a == PairState::Joined || b == PairState::Joined ? SeamGraph::Rule::NeverCut : otherwise;
}

std::vector<int> eliminationOrder(const SeamGraph &graph)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < graph.vertexCount; ++v)
        entries.emplace_back(v, v, 1.0);
    // From the triangles: graph.ends lacks the borders.
    for (int c = 0; c < static_cast<int>(graph.vertex.size()); ++c) {
        const int a = graph.vertex[c], b = graph.vertex[c / 3 * 3 + (c + 1) % 3];
        entries.emplace_back(std::max(a, b), std::min(a, b), 1.0);
    }
    linear::LinearSolver::Matrix pattern(graph.vertexCount, graph.vertexCount);
    pattern.setFromTriplets(entries.begin(), entries.end());
    return linear::eliminationRanks(pattern);
}

//! Of edges without a mirror image between vertices that have one. Chosen by hand.
constexpr double lopsidedCost = 2;

//! Stores the mirror images and makes costs and rules symmetric: an edge and its image get their mean cost,
//! and a free edge takes the rule of its image.
void mirrorGraph(const MeshData &mesh, const preference::MeshSymmetry &symmetry, SeamGraph &graph)
{
    graph.mirror = symmetry.mirrorEdge;
    graph.onPlane.assign(graph.vertexCount, false);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        const int v = mesh.vertexOfSoup(c);
        if (symmetry.mirrorVertex[v] == v)
            graph.onPlane[graph.vertex[c]] = true;
    }
    const std::vector<double> cost = graph.cost;
    const std::vector<SeamGraph::Rule> rule = graph.rule;
    for (std::size_t e = 0; e < cost.size(); ++e) {
        const int other = graph.mirror[e];
        if (other < 0) {
            // A triangle that is split the other way on the other side: better cut beside it.
            const auto hasImage = [&](int end) {
                return symmetry.mirrorVertex[mesh.vertexOfSoup(mesh.edgePairs[e].corner[end][0])] >= 0;
            };
            if (hasImage(0) && hasImage(1))
                graph.cost[e] *= lopsidedCost;
            continue;
        }
        graph.cost[e] = 0.5 * (cost[e] + cost[other]);
        if (rule[e] == SeamGraph::Rule::Free)
            graph.rule[e] = rule[other];
    }
}

} // namespace

void SeamGraph::makeSymmetric(CutFlags &cut) const
{
    for (std::size_t e = 0; e < mirror.size(); ++e) {
        if (cut[e] && mirror[e] >= 0 && rule[mirror[e]] != Rule::NeverCut)
            cut[mirror[e]] = true;
    }
}

std::shared_ptr<const SeamGraph> SeamGraph::build(std::shared_ptr<const Soup> soup, const Snapshot &snapshot,
                                                  const preference::MeshSymmetry *symmetry)
{
    auto graph = std::make_shared<SeamGraph>();
    const MeshData &mesh = *soup->mesh;
    const CutMesh whole(mesh, CutFlags(mesh.edgePairs.size(), false));
    graph->across = whole.neighbour;
    graph->vertex = whole.uvVertex;
    graph->vertexCount = whole.uvVertexCount;
    graph->edgeOf.assign(mesh.soupCornerCount(), -1);
    std::vector<std::pair<int, int>> edgesOfPoint;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        for (int which = 0; which < 2; ++which)
            graph->edgeOf[3 * pair.triangle[which] + pair.side(which)] = static_cast<int>(e);
        graph->ends.push_back({whole.uvVertex[pair.corner[0][0]], whole.uvVertex[pair.corner[1][0]]});
        graph->length.push_back(soup->pairLength[2 * e]);
        for (const int v : graph->ends.back())
            edgesOfPoint.emplace_back(v, static_cast<int>(e));
    }
    graph->edgesOfPoint = {graph->vertexCount, edgesOfPoint};
    graph->border.assign(graph->vertexCount, false);
    for (int side = 0; side < mesh.soupCornerCount(); ++side) {
        if (graph->across[side] < 0)
            graph->border[whole.uvVertex[side]] =
                graph->border[whole.uvVertex[side / 3 * 3 + (side + 1) % 3]] = true;
    }
    graph->soup = std::move(soup);
    graph->rank = eliminationOrder(*graph);
    graph->setSteering(snapshot, symmetry);
    return graph;
}

std::shared_ptr<const SeamGraph> SeamGraph::steeredBy(const Snapshot &snapshot,
                                                      const preference::MeshSymmetry *symmetry) const
{
    const auto graph = std::make_shared<SeamGraph>(*this);
    graph->setSteering(snapshot, symmetry);
    return graph;
}

void SeamGraph::setSteering(const Snapshot &snapshot, const preference::MeshSymmetry *symmetry)
{
    cost.clear();
    rule.clear();
    mirror.clear();
    onPlane.clear();
    for (std::size_t e = 0; e < length.size(); ++e) {
        const double weight =
            snapshot.settings.weighting == SeamWeighting::Count ? soup->meanEdgeLength : length[e];
        cost.push_back(weight * snapshot.edgeWeight(e));
        rule.push_back(ruleOf(snapshot, e));
    }
    if (symmetry)
        mirrorGraph(*soup->mesh, *symmetry, *this);
    aligned = snapshot.aligned;
    energy = snapshot.settings.energy;
    rigid = snapshot.rigid;
    anchors = Anchors(snapshot);
    obstacles = snapshot.obstacles;
}

} // namespace autocuts::search
