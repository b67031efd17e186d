#include "solver/metrics/uvgutter.h"

#include "solver/overlap/nearcharts.h"

#include <limits>
#include <map>

namespace autocuts::metrics {

double smallestGutter(const UvMatrix &uv, const UvTopology &topology, const std::vector<int> &stacks)
{
    std::map<int, int> firstOfStack;
    const auto pileOf = [&](int chart) {
        return stacks[chart] == 0 ? chart : firstOfStack.try_emplace(stacks[chart], chart).first->second;
    };
    std::vector<overlap::BorderSegment> borders;
    for (const UvEdge &edge : topology.uvEdges) {
        if (edge.open)
            borders.push_back({uv.row(edge.corner[0]), uv.row(edge.corner[1]), pileOf(edge.chart)});
    }
    if (topology.charts.count < 2 || borders.empty())
        return std::numeric_limits<double>::infinity();
    return overlap::NearCharts(std::move(borders)).smallestDistance();
}

} // namespace autocuts::metrics
