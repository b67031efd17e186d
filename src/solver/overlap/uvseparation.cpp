#include "solver/overlap/uvseparation.h"

#include "model/plain/uvlayout.h"
#include "solver/base/cutmesh.h"
#include "solver/overlap/overlapseparation.h"

namespace autocuts::overlap {

Separated separateUv(const MeshData &mesh, const UvMatrix &uv, const std::atomic<bool> *cancel)
{
    const ChartMap before = findCharts(mesh, uv);
    const UvMatrix soup = soupUv(mesh, uv);

    const Eigen::AlignedBox2d box = layoutBox(uv);
    const double tolerance = box.isEmpty() ? 0 : 1e-6 * box.diagonal().norm();
    CutFlags cut(mesh.edgePairs.size(), false);
    for (std::size_t e = 0; e < cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        bool agree = true;
        for (int end = 0; end < 2; ++end)
            agree =
                agree && (soup.row(pair.corner[end][0]) - soup.row(pair.corner[end][1])).norm() <= tolerance;
        cut[e] = !pair.diagonal && !agree;
    }
    SeparationOptions options;
    options.cancel = cancel;
    const SeparationResult result = separateOverlaps(mesh, soup, cut, {}, options);

    Separated separated;
    separated.complete = result.complete;
    separated.newSeams = result.newSeams;
    separated.unresolvedPairs = result.unresolvedPairs;
    const CutMesh state(mesh, result.cut);
    separated.charts.faceChart.assign(mesh.faceCount(), -1);
    separated.charts.count = state.chartCount;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (before.faceChart[face] >= 0)
            separated.charts.faceChart[face] = state.chart[t];
    }
    return separated;
}

} // namespace autocuts::overlap
