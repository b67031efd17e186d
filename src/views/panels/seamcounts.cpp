#include "views/panels/seamcounts.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

SeamCounts countSeams(const MeshData &mesh, const Seams &seams)
{
    SeamCounts counts;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (mesh.edgePairs[e].diagonal)
            continue;
        const auto has = [&](PairState state) {
            return seams.states[2 * e] == state || seams.states[2 * e + 1] == state;
        };
        if (seams.edgeIs(int(e), PairState::Cut))
            ++counts.cut;
        else if (has(PairState::Cut))
            ++counts.halfCut;
        if (has(PairState::Joined))
            ++counts.joined;
        counts.straight += seams.straight[2 * e] != 0;
        const auto [low, high] = std::minmax(seams.weights[2 * e], seams.weights[2 * e + 1]);
        counts.keptTogether += high > unpaintedWeight;
        counts.attracting += low < unpaintedWeight;
    }
    return counts;
}

std::vector<int> edgesOfFaces(const Document &document, const QList<int> &faces)
{
    const MeshData &mesh = document.mesh();
    const int pairCount = static_cast<int>(mesh.edgePairs.size());
    std::vector<int> edges;
    for (int face : faces) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            if (const int edge = document.adjacency().edgeOfCorner(c); edge < pairCount)
                edges.push_back(edge);
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

double keepTogetherWeight(double strength)
{
    return std::pow(100.0, strength);
}

double attractCutsWeight(double strength)
{
    return 1 - strength;
}

} // namespace autocuts
