#include "solver/overlap/uvseparation.h"

#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/base/cutmesh.h"

namespace autocuts::overlap {

SeparationResult separateSteered(const Snapshot &snapshot, const UvMatrix &soupUv,
                                 const std::vector<bool> &cut, const JobContext &job, SeparationMethod method)
{
    SeparationOptions options;
    options.method = method;
    options.job = job;
    if (!snapshot.steering->pairWeight.empty()) {
        options.pairWeight.resize(cut.size());
        for (std::size_t e = 0; e < cut.size(); ++e)
            options.pairWeight[e] = snapshot.edgeWeight(e);
    }
    std::vector<bool> joined(cut.size());
    for (std::size_t e = 0; e < cut.size(); ++e)
        joined[e] = snapshot.isJoined(e);
    return separateOverlaps(*snapshot.mesh, soupUv, cut, joined, options);
}

Separated separateUv(const Snapshot &snapshot, const UvMatrix &uv, const JobContext &job,
                     SeparationMethod method)
{
    const MeshData &mesh = *snapshot.mesh;
    const ChartMap before = findCharts(mesh, uv);
    const UvMatrix soup = soupUv(mesh, uv);

    const std::vector<bool> open = openCornerPairs(mesh, uv);
    CutFlags cut(mesh.edgePairs.size(), false);
    for (std::size_t e = 0; e < cut.size(); ++e)
        cut[e] = open[2 * e] || open[2 * e + 1];
    const SeparationResult result = separateSteered(snapshot, soup, cut, job, method);

    Separated separated;
    separated.complete = result.complete;
    separated.newSeams = result.newSeams;
    separated.unresolvedPairs = result.unresolvedPairs;
    const CutMesh state(mesh, result.cut);
    separated.charts.faceChart.assign(mesh.faceCount(), -1);
    // Faces without UVs are in charts of the mesh, but not of the map.
    std::vector<int> number(state.chartCount, -1);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (before.faceChart[face] < 0)
            continue;
        int &chart = number[state.chart[t]];
        if (chart < 0)
            chart = separated.charts.count++;
        separated.charts.faceChart[face] = chart;
    }
    return separated;
}

} // namespace autocuts::overlap
