#include "solver/packing/layoutcheck.h"

#include "solver/base/segmentcrossing.h"

#include <algorithm>

namespace autocuts::packing {

namespace {

bool insideBin(const PackProblem &problem, const Layout &layout)
{
    // For rounding only: the border of the problem is a little wider than the user's.
    const Vec2 slack = 1e-12 * (problem.lower.cwiseAbs() + problem.upper.cwiseAbs());
    const Vec2 lower = problem.lower - slack, upper = problem.upper + slack;
    for (int i = 0; i < problem.count(); ++i) {
        if (!problem.movable(i))
            continue;
        const Pose &pose = layout.poses[i];
        const Turn turn(pose.angle, layout.scale);
        for (const Vec2 &p : problem.outlines[i].hull) {
            const Vec2 q = turn(p) + pose.position;
            // The comparison is false for NaN.
            if (!(q.x() >= lower.x() && q.y() >= lower.y() && q.x() <= upper.x() && q.y() <= upper.y()))
                return false;
        }
    }
    return true;
}

bool edgesKeepDistance(const PlacedEdge &p, const PlacedEdge &q, double gutter)
{
    if (std::max(p.a.x(), p.b.x()) + gutter <= std::min(q.a.x(), q.b.x()) ||
        std::max(q.a.x(), q.b.x()) + gutter <= std::min(p.a.x(), p.b.x()) ||
        std::max(p.a.y(), p.b.y()) + gutter <= std::min(q.a.y(), q.b.y()) ||
        std::max(q.a.y(), q.b.y()) + gutter <= std::min(p.a.y(), p.b.y()))
        return true;
    const double limit = gutter * gutter;
    return pointSegmentSquared(p.a, q.a, q.b) >= limit && pointSegmentSquared(p.b, q.a, q.b) >= limit &&
           pointSegmentSquared(q.a, p.a, p.b) >= limit && pointSegmentSquared(q.b, p.a, p.b) >= limit &&
           !segmentsCross(p.a, p.b, q.a, q.b);
}

bool cellKeepsDistance(const PackProblem &problem, const std::vector<PlacedEdge> &edges, const int *begin,
                       const int *end, double &tests)
{
    if (begin == end || edges[*begin].island == edges[end[-1]].island)
        return true;
    const int *group = begin;
    for (const int *i = begin; i != end; ++i) {
        if (edges[*i].island != edges[*group].island)
            group = i;
        const bool isLocked = problem.locked[edges[*i].island];
        for (const int *j = begin; j != group; ++j) {
            if (isLocked && problem.locked[edges[*j].island])
                continue;
            if (!edgesKeepDistance(edges[*i], edges[*j], problem.gutter))
                return false;
        }
        tests += static_cast<double>(group - begin);
    }
    return true;
}

//! True when no island lies inside another one. Tests one point of each connected component.
//! \pre edges of different islands keep their distance, so that a component is inside or outside as a whole
bool nothingContained(const PackProblem &problem, const Layout &layout,
                      const std::vector<Eigen::AlignedBox2d> &boxes, double &tests)
{
    std::vector<PlacedEdge> points;
    for (int i = 0; i < problem.count(); ++i) {
        const Turn turn(layout.poses[i].angle, problem.scaleOf(i, layout.scale));
        for (const int point : problem.outlines[i].componentPoints) {
            const Vec2 p = turn(problem.outlines[i].points[point]) + layout.poses[i].position;
            points.push_back({p, p, i});
        }
    }
    const SegmentGrid grid(points, problem.lower, problem.upper, 0);
    for (int i = 0; i < problem.count(); ++i) {
        if (boxes[i].isEmpty())
            continue;
        const Turn back(layout.poses[i].angle, 1 / problem.scaleOf(i, layout.scale));
        const auto keepsOut = [&](const PlacedEdge &point) {
            tests += 0.2;
            if (point.island == i || (problem.locked[i] && problem.locked[point.island]) ||
                !boxes[i].contains(point.a))
                return true;
            tests += 4;
            return problem.outlines[i].windingAt(back.transposed(point.a - layout.poses[i].position)) == 0;
        };
        const bool isFree = grid.visitCellsOf(boxes[i], [&](int cell) {
            return std::all_of(grid.begin(cell), grid.end(cell), [&](int p) { return keepsOut(points[p]); });
        });
        if (!isFree)
            return false;
    }
    return true;
}

} // namespace

std::vector<PlacedEdge> placedEdges(const PackProblem &problem, const Layout &layout)
{
    std::vector<PlacedEdge> edges;
    std::size_t count = 0;
    for (const Outline &outline : problem.outlines)
        count += outline.edges.size();
    edges.reserve(count);
    std::vector<Vec2> points;
    for (int i = 0; i < problem.count(); ++i) {
        placePoints(problem.outlines[i], layout.poses[i], problem.scaleOf(i, layout.scale), points);
        for (const Outline::Edge &e : problem.outlines[i].edges)
            edges.push_back({points[e.a], points[e.b], i});
    }
    return edges;
}

bool isValidLayout(const PackProblem &problem, const Layout &layout, WorkMeter &work)
{
    if (!(layout.scale > 0) || !insideBin(problem, layout))
        return false;
    const std::vector<PlacedEdge> edges = placedEdges(problem, layout);
    const SegmentGrid grid(edges, problem.lower, problem.upper, 0.5 * problem.gutter);
    double tests = 0;
    bool valid = true;
    for (int c = 0; c < grid.cellCount() && valid; ++c)
        valid = cellKeepsDistance(problem, edges, grid.begin(c), grid.end(c), tests);
    if (valid) {
        std::vector<Eigen::AlignedBox2d> boxes(problem.count());
        for (const PlacedEdge &e : edges) {
            boxes[e.island].extend(e.a);
            boxes[e.island].extend(e.b);
        }
        valid = nothingContained(problem, layout, boxes, tests);
    }
    work.add(12 * tests + 40 * static_cast<double>(edges.size()) + 10.0 * grid.entryCount() +
             grid.cellCount());
    return valid;
}

} // namespace autocuts::packing
