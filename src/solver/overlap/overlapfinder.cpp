#include "solver/overlap/overlapfinder.h"

#include "solver/overlap/boxtree.h"
#include "solver/overlap/predicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace autocuts::overlap {

namespace {

using Triangle = std::array<Vec2, 3>;

//! A convex polygon on the stack. Clipping a triangle by three lines gives at most six points; rounding may
//! add a few more.
struct ClipPolygon
{
    std::array<Vec2, 12> point;
    int size = 0;

    void add(const Vec2 &p)
    {
        if (size < static_cast<int>(point.size()))
            point[size++] = p;
    }
};

//! True when all of `b` is outside or on the line along one side of `a`.
bool separatedBySide(const Triangle &a, const Triangle &b)
{
    for (int i = 0; i < 3; ++i) {
        const Vec2 &from = a[i];
        const Vec2 &to = a[(i + 1) % 3];
        if (orientation(from, to, b[0]) <= 0 && orientation(from, to, b[1]) <= 0 &&
            orientation(from, to, b[2]) <= 0)
            return true;
    }
    return false;
}

//! Clips the polygon: keeps what is to the left of the line through `from` along `direction`.
ClipPolygon clipped(const ClipPolygon &polygon, const Vec2 &from, const Vec2 &direction)
{
    const auto height = [&](const Vec2 &p) {
        return direction.x() * (p.y() - from.y()) - direction.y() * (p.x() - from.x());
    };
    ClipPolygon result;
    for (int i = 0; i < polygon.size; ++i) {
        const Vec2 &p = polygon.point[i];
        const Vec2 &q = polygon.point[(i + 1) % polygon.size];
        const double atP = height(p);
        const double atQ = height(q);
        if (atP >= 0)
            result.add(p);
        if ((atP > 0 && atQ < 0) || (atP < 0 && atQ > 0))
            result.add(p + (atP / (atP - atQ)) * (q - p));
    }
    return result;
}

//! All finite triangles with area, turned counter-clockwise, and their indices in the input.
struct Prepared
{
    std::vector<Triangle> triangles;
    std::vector<int> source;
    std::vector<Eigen::AlignedBox2d> boxes;
    double area = 0;
};

Prepared prepare(const UvMatrix &uv, const std::vector<int> &which)
{
    Prepared result;
    result.triangles.reserve(which.size());
    for (int t : which) {
        if (!uv.middleRows<3>(3 * t).allFinite())
            continue;
        Triangle triangle{uv.row(3 * t), uv.row(3 * t + 1), uv.row(3 * t + 2)};
        const int turn = orientation(triangle[0], triangle[1], triangle[2]);
        if (turn == 0)
            continue;
        if (turn < 0)
            std::swap(triangle[1], triangle[2]);
        result.area += 0.5 * std::abs(cross2(triangle[0], triangle[1], triangle[2]));
        Eigen::AlignedBox2d box;
        for (const Vec2 &p : triangle)
            box.extend(p);
        result.triangles.push_back(triangle);
        result.source.push_back(t);
        result.boxes.push_back(box);
    }
    return result;
}

std::vector<int> allTriangles(const UvMatrix &uv)
{
    std::vector<int> all(uv.rows() / 3);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

bool visitAmong(const UvMatrix &uv, const std::vector<int> &which, const OverlapOptions &options,
                const std::function<bool(int, int, double)> &visit)
{
    Prepared prepared = prepare(uv, which);
    const double minArea = options.minAreaRatio * (options.totalArea > 0 ? options.totalArea : prepared.area);
    const BoxTree tree(std::move(prepared.boxes));
    unsigned untilPoll = 0;
    return tree.visitOverlappingPairs([&](int a, int b) {
        if ((++untilPoll & 1023u) == 0 && options.job.stopped())
            return false;
        const double area = intersectionArea(prepared.triangles[a], prepared.triangles[b]);
        if (!(area > minArea))
            return true;
        const auto [low, high] = std::minmax(prepared.source[a], prepared.source[b]);
        return visit(low, high, area);
    });
}

} // namespace

double intersectionArea(const std::array<Vec2, 3> &a, const std::array<Vec2, 3> &b)
{
    // Two convex polygons have disjoint interiors exactly when a side of one of them separates them.
    if (separatedBySide(a, b) || separatedBySide(b, a))
        return 0;
    // Computed relative to a corner, so that no digits are lost far from the origin.
    const Vec2 origin = a[0];
    ClipPolygon polygon;
    for (const Vec2 &p : a)
        polygon.add(p - origin);
    for (int i = 0; i < 3 && polygon.size >= 3; ++i)
        polygon = clipped(polygon, b[i] - origin, b[(i + 1) % 3] - b[i]);
    double doubled = 0;
    for (int i = 1; i + 1 < polygon.size; ++i)
        doubled += cross2(polygon.point[0], polygon.point[i], polygon.point[i + 1]);
    return std::max(0.0, 0.5 * doubled);
}

double totalUvArea(const UvMatrix &uv)
{
    double area = 0;
    for (Eigen::Index t = 0; t + 2 < uv.rows(); t += 3) {
        const double doubled = std::abs(cross2(uv.row(t), uv.row(t + 1), uv.row(t + 2)));
        if (std::isfinite(doubled))
            area += 0.5 * doubled;
    }
    return area;
}

bool visitOverlaps(const UvMatrix &uv, const OverlapOptions &options,
                   const std::function<bool(int, int, double)> &visit)
{
    return visitAmong(uv, allTriangles(uv), options, visit);
}

bool visitOverlapsWithin(const UvMatrix &uv, const std::vector<int> &group, const OverlapOptions &given,
                         const std::function<bool(int, int, double)> &visit)
{
    OverlapOptions options = given;
    if (!(options.totalArea > 0))
        options.totalArea = totalUvArea(uv);
    std::vector<int> order = allTriangles(uv);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return group[a] < group[b]; });
    for (auto first = order.begin(); first != order.end();) {
        const auto last = std::find_if(first, order.end(), [&](int t) { return group[t] != group[*first]; });
        if (options.job.stopped() || (last - first > 1 && !visitAmong(uv, {first, last}, options, visit)))
            return false;
        first = last;
    }
    return true;
}

OverlapList findOverlaps(const UvMatrix &uv, const OverlapOptions &options)
{
    return findOverlapsAmong(uv, allTriangles(uv), options);
}

OverlapList findOverlapsAmong(const UvMatrix &uv, const std::vector<int> &triangles,
                              const OverlapOptions &options)
{
    OverlapList list;
    list.complete = visitAmong(uv, triangles, options, [&](int a, int b, double area) {
        if (list.pairs.size() >= options.maxPairs)
            return false;
        list.pairs.push_back({a, b, area});
        return true;
    });
    std::sort(list.pairs.begin(), list.pairs.end(), [](const OverlapPair &a, const OverlapPair &b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    return list;
}

} // namespace autocuts::overlap
