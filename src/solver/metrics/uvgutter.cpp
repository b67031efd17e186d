#include "solver/metrics/uvgutter.h"

#include "solver/base/segmentcrossing.h"
#include "solver/overlap/boxtree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace autocuts::metrics {

namespace {

struct Segment
{
    Vec2 from, to;
    int chart; //!< of a stack: one of its charts
};

double squaredDistance(const Vec2 &point, const Segment &segment)
{
    const Vec2 along = segment.to - segment.from;
    const double length = along.squaredNorm();
    const double place = length > 0 ? std::clamp((point - segment.from).dot(along) / length, 0.0, 1.0) : 0.0;
    return (point - segment.from - place * along).squaredNorm();
}

double squaredDistance(const Segment &a, const Segment &b)
{
    if (segmentsCross(a.from, a.to, b.from, b.to))
        return 0;
    return std::min({squaredDistance(a.from, b), squaredDistance(a.to, b), squaredDistance(b.from, a),
                     squaredDistance(b.to, a)});
}

//! Per node: the chart of all segments below it, -1 when there are several.
std::vector<int> nodeCharts(const overlap::BoxTree &tree, const std::vector<Segment> &segments)
{
    const auto &nodes = tree.nodes();
    std::vector<int> chart(nodes.size());
    for (int i = static_cast<int>(nodes.size()) - 1; i >= 0; --i) {
        const overlap::BoxTree::Node &node = nodes[i];
        if (node.count == 0) {
            chart[i] = chart[i + 1] == chart[node.right] ? chart[i + 1] : -1;
            continue;
        }
        chart[i] = segments[tree.order()[node.first]].chart;
        for (int k = node.first; k < node.first + node.count; ++k) {
            if (segments[tree.order()[k]].chart != chart[i])
                chart[i] = -1;
        }
    }
    return chart;
}

//! Lowers `best` to the squared distance from segment `i` to its nearest segment of another chart.
void searchNearest(const overlap::BoxTree &tree, const std::vector<Segment> &segments,
                   const std::vector<int> &nodeChart, int i, double &best)
{
    std::vector<std::pair<double, int>> stack{{tree.nodes()[0].box.squaredExteriorDistance(tree.box(i)), 0}};
    while (!stack.empty()) {
        const auto [distance, id] = stack.back();
        stack.pop_back();
        if (distance >= best || nodeChart[id] == segments[i].chart)
            continue;
        const overlap::BoxTree::Node &node = tree.nodes()[id];
        for (int k = node.first; k < node.first + node.count; ++k) {
            const int other = tree.order()[k];
            if (segments[other].chart != segments[i].chart)
                best = std::min(best, squaredDistance(segments[i], segments[other]));
        }
        if (node.count > 0)
            continue;
        std::pair<double, int> near{tree.nodes()[id + 1].box.squaredExteriorDistance(tree.box(i)), id + 1};
        std::pair<double, int> far{tree.nodes()[node.right].box.squaredExteriorDistance(tree.box(i)),
                                   node.right};
        if (far.first < near.first)
            std::swap(near, far);
        stack.push_back(far);
        stack.push_back(near);
    }
}

} // namespace

double smallestGutter(const UvMatrix &uv, const UvTopology &topology, const std::vector<int> &stacks)
{
    double best = std::numeric_limits<double>::infinity();
    std::map<int, int> firstOfStack;
    const auto pileOf = [&](int chart) {
        return stacks[chart] == 0 ? chart : firstOfStack.try_emplace(stacks[chart], chart).first->second;
    };
    if (topology.charts.count < 2)
        return best;
    std::vector<Segment> segments;
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const UvEdge &edge : topology.uvEdges) {
        if (!edge.open)
            continue;
        segments.push_back({uv.row(edge.corner[0]), uv.row(edge.corner[1]), pileOf(edge.chart)});
        boxes.emplace_back(segments.back().from).extend(segments.back().to);
    }
    if (segments.empty())
        return best;
    const overlap::BoxTree tree(std::move(boxes));
    const std::vector<int> nodeChart = nodeCharts(tree, segments);
    for (int i = 0; i < static_cast<int>(segments.size()) && best > 0; ++i)
        searchNearest(tree, segments, nodeChart, i, best);
    return std::sqrt(best);
}

} // namespace autocuts::metrics
