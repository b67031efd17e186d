#include "solver/overlap/nearcharts.h"

#include "model/plain/uvseams.h"
#include "solver/base/segmentcrossing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::overlap {

namespace {

double squaredDistance(const BorderSegment &a, const BorderSegment &b)
{
    if (segmentsCross(a.from, a.to, b.from, b.to))
        return 0;
    return std::min({pointSegmentSquared(a.from, b.from, b.to), pointSegmentSquared(a.to, b.from, b.to),
                     pointSegmentSquared(b.from, a.from, a.to), pointSegmentSquared(b.to, a.from, a.to)});
}

std::vector<Eigen::AlignedBox2d> boxesOf(const std::vector<BorderSegment> &borders)
{
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const BorderSegment &segment : borders)
        boxes.emplace_back(segment.from).extend(segment.to);
    return boxes;
}

std::vector<int> nodeCharts(const BoxTree &tree, const std::vector<BorderSegment> &borders)
{
    const auto &nodes = tree.nodes();
    std::vector<int> chart(nodes.size());
    for (int i = static_cast<int>(nodes.size()) - 1; i >= 0; --i) {
        const BoxTree::Node &node = nodes[i];
        if (node.count == 0) {
            chart[i] = chart[i + 1] == chart[node.right] ? chart[i + 1] : -1;
            continue;
        }
        chart[i] = borders[tree.order()[node.first]].chart;
        for (int k = node.first; k < node.first + node.count; ++k) {
            if (borders[tree.order()[k]].chart != chart[i])
                chart[i] = -1;
        }
    }
    return chart;
}

} // namespace

std::vector<BorderSegment> chartBorders(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv)
{
    std::vector<BorderSegment> borders;
    const auto add = [&](int triangle, int side) {
        const int chart = charts.faceChart[mesh.triangleFace[triangle]];
        const std::array<int, 3> &corners = mesh.triangles[triangle];
        if (chart >= 0)
            borders.push_back({uv.row(corners[side]), uv.row(corners[(side + 1) % 3]), chart});
    };
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (!open[2 * e] && !open[2 * e + 1])
            continue;
        for (const int which : {0, 1})
            add(pair.triangle[which], pair.side(which));
    }
    for (const BoundarySide &side : mesh.boundarySides)
        add(side.triangle, side.side);
    return borders;
}

NearCharts::NearCharts(std::vector<BorderSegment> borders)
    : mBorders(std::move(borders)), mTree(boxesOf(mBorders)), mNodeChart(nodeCharts(mTree, mBorders))
{}

double NearCharts::smallestDistance() const
{
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < static_cast<int>(mBorders.size()) && best > 0; ++i)
        searchNearest(i, best);
    return std::sqrt(best);
}

//! Lowers `best` to the squared distance from a segment to its nearest segment of another chart.
void NearCharts::searchNearest(int segment, double &best) const
{
    std::vector<std::pair<double, int>> stack{
        {mTree.nodes()[0].box.squaredExteriorDistance(mTree.box(segment)), 0}};
    while (!stack.empty()) {
        const auto [distance, id] = stack.back();
        stack.pop_back();
        if (distance >= best || mNodeChart[id] == mBorders[segment].chart)
            continue;
        const BoxTree::Node &node = mTree.nodes()[id];
        for (int k = node.first; k < node.first + node.count; ++k) {
            const int other = mTree.order()[k];
            if (mBorders[segment].chart != mBorders[other].chart)
                best = std::min(best, squaredDistance(mBorders[segment], mBorders[other]));
        }
        if (node.count > 0)
            continue;
        std::pair<double, int> near{mTree.nodes()[id + 1].box.squaredExteriorDistance(mTree.box(segment)),
                                    id + 1};
        std::pair<double, int> far{mTree.nodes()[node.right].box.squaredExteriorDistance(mTree.box(segment)),
                                   node.right};
        if (far.first < near.first)
            std::swap(near, far);
        stack.push_back(far);
        stack.push_back(near);
    }
}

void NearCharts::visitNearer(double distance, const std::function<void(int, int, double)> &visit) const
{
    const double limit = distance * distance;
    std::vector<int> stack;
    for (int i = 0; i < static_cast<int>(mBorders.size()); ++i) {
        const int chart = mBorders[i].chart;
        stack.assign(1, 0);
        while (!stack.empty()) {
            const int id = stack.back();
            stack.pop_back();
            const BoxTree::Node &node = mTree.nodes()[id];
            if (mNodeChart[id] == chart || node.box.squaredExteriorDistance(mTree.box(i)) >= limit)
                continue;
            for (int k = node.first; k < node.first + node.count; ++k) {
                const int other = mTree.order()[k];
                if (other <= i || mBorders[other].chart == chart)
                    continue;
                if (const double squared = squaredDistance(mBorders[i], mBorders[other]); squared < limit)
                    visit(chart, mBorders[other].chart, std::sqrt(squared));
            }
            if (node.count == 0) {
                stack.push_back(node.right);
                stack.push_back(id + 1);
            }
        }
    }
}

} // namespace autocuts::overlap
