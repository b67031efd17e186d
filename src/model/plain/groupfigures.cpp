#include "model/plain/groupfigures.h"

#include "model/plain/chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autocuts::metrics {

std::vector<GroupFigures> groupFigures(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                                       const std::vector<int> &faceGroup, int count,
                                       const std::vector<double> &chartSymDirichlet)
{
    std::vector<GroupFigures> figures(static_cast<std::size_t>(count));
    std::vector<std::pair<int, int>> chartsOf; // group and chart, sorted below
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int group = faceGroup[face];
        ++figures[static_cast<std::size_t>(group)].faces;
        const std::pair own(group, charts.faceChart[face]);
        if (own.second >= 0 && (chartsOf.empty() || chartsOf.back() != own)) // neighbours are often alike
            chartsOf.push_back(own);
    }
    std::ranges::sort(chartsOf);
    chartsOf.erase(std::unique(chartsOf.begin(), chartsOf.end()), chartsOf.end());
    for (const auto &[group, chart] : chartsOf)
        ++figures[static_cast<std::size_t>(group)].charts;
    std::vector<double> area(figures.size(), 0), measured(figures.size(), 0), energy(figures.size(), 0);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        const int chart = charts.faceChart[face];
        if (chart < 0)
            continue;
        const auto group = static_cast<std::size_t>(faceGroup[face]);
        const auto &[a, b, c] = mesh.triangles[t];
        area[group] += mesh.triangleArea[t];
        figures[group].uvArea += std::abs(cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)))) / 2;
        const auto number = static_cast<std::size_t>(chart);
        if (number < chartSymDirichlet.size() && std::isfinite(chartSymDirichlet[number])) {
            measured[group] += mesh.triangleArea[t];
            energy[group] += mesh.triangleArea[t] * chartSymDirichlet[number];
        }
    }
    for (std::size_t g = 0; g < figures.size(); ++g) {
        if (measured[g] > 0)
            figures[g].symDirichlet = energy[g] / measured[g];
        if (area[g] > 0)
            figures[g].density = std::sqrt(figures[g].uvArea / area[g]);
    }
    return figures;
}

} // namespace autocuts::metrics
