#include "solver/packing/outline.h"

#include "model/plain/unionfind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace autocuts::packing {

namespace {

// Numbers in this file without another source were chosen by hand.

struct DirectedEdge
{
    int low, high, winding;
};

bool lexicographicLess(const Vec2 &a, const Vec2 &b)
{
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

//! Welds points at exactly the same position: per point the first one there, -1 when the point is not usable.
std::vector<int> weldPoints(const std::vector<Vec2> &points)
{
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        if (isUsablePoint(points[i]))
            order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return points[a] == points[b] ? a < b : lexicographicLess(points[a], points[b]);
    });
    std::vector<int> weld(points.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
        weld[order[i]] = same ? weld[order[i - 1]] : order[i];
    }
    return weld;
}

//! Edges where the winding number changes, and the island's boundary edges.
std::vector<DirectedEdge> shapeEdges(const PackIsland &island, const std::vector<int> &weld)
{
    std::vector<DirectedEdge> edges;
    const auto add = [&](int a, int b, int winding) {
        if (a < b)
            edges.push_back({a, b, winding});
        else
            edges.push_back({b, a, -winding});
    };
    for (const auto &t : island.triangles) {
        const int a = weld[t[0]], b = weld[t[1]], c = weld[t[2]];
        if (a < 0 || b < 0 || c < 0)
            continue;
        const double area = cross2(island.points[a], island.points[b], island.points[c]);
        if (area == 0)
            continue;
        const int sign = area > 0 ? 1 : -1;
        add(a, b, sign);
        add(b, c, sign);
        add(c, a, sign);
    }
    const auto inner = edges.size();
    for (const auto &e : island.boundary) {
        if (weld[e[0]] >= 0 && weld[e[1]] >= 0)
            add(weld[e[0]], weld[e[1]], 0);
    }
    std::vector<char> open(edges.size(), 0);
    std::vector<int> order(edges.size());
    for (int i = 0; i < static_cast<int>(order.size()); ++i) {
        order[i] = i;
        open[i] = static_cast<std::size_t>(i) >= inner;
    }
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return std::tie(edges[i].low, edges[i].high, i) < std::tie(edges[j].low, edges[j].high, j);
    });
    std::vector<DirectedEdge> result;
    for (std::size_t i = 0; i < order.size();) {
        DirectedEdge sum{edges[order[i]].low, edges[order[i]].high, 0};
        bool isOpen = false;
        for (; i < order.size() && edges[order[i]].low == sum.low && edges[order[i]].high == sum.high; ++i) {
            sum.winding += edges[order[i]].winding;
            isOpen = isOpen || open[order[i]];
        }
        if (sum.winding != 0 || isOpen)
            result.push_back(sum);
    }
    return result;
}

//! Sides of all triangles, and all points as edges of zero length: for islands without area and boundary,
//! which still have to keep the gutter.
std::vector<DirectedEdge> allEdges(const PackIsland &island, const std::vector<int> &weld)
{
    std::vector<DirectedEdge> edges;
    for (const auto &t : island.triangles) {
        for (int k = 0; k < 3; ++k) {
            const int a = weld[t[k]], b = weld[t[(k + 1) % 3]];
            if (a >= 0 && b >= 0 && a != b)
                edges.push_back({a, b, 0});
        }
    }
    for (int i = 0; i < static_cast<int>(weld.size()); ++i) {
        if (weld[i] == i)
            edges.push_back({i, i, 0});
    }
    return edges;
}

//! Convex hull, counter-clockwise (Andrew's monotone chain, 1979).
std::vector<Vec2> convexHull(std::vector<Vec2> points)
{
    std::sort(points.begin(), points.end(), lexicographicLess);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return points;
    std::vector<Vec2> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t base = hull.size();
        for (const Vec2 &p : points) {
            while (hull.size() >= base + 2 && cross2(hull[hull.size() - 2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

double leastBoxAngle(const std::vector<Vec2> &hull)
{
    double best = std::numeric_limits<double>::infinity();
    double angle = 0;
    // At most about 64 sides are tried. Chosen by hand: hulls of many sides have many nearly equal boxes.
    const std::size_t step = hull.size() / 64 + 1;
    for (std::size_t i = 0; i < hull.size() && hull.size() > 1; i += step) {
        const Vec2 side = hull[(i + 1) % hull.size()] - hull[i];
        const double candidate = -std::atan2(side.y(), side.x());
        const Vec2 box = rotatedBox(hull, candidate);
        const double area = box.x() * box.y();
        if (area < best) {
            best = area;
            angle = candidate;
        }
    }
    return angle;
}

void buildStrips(Outline &outline)
{
    double low = std::numeric_limits<double>::infinity(), high = -low, rise = 0;
    for (const Outline::Edge &e : outline.edges) {
        const double ya = outline.points[e.a].y(), yb = outline.points[e.b].y();
        low = std::min({low, ya, yb});
        high = std::max({high, ya, yb});
        rise += std::abs(ya - yb);
    }
    const double count = static_cast<double>(outline.edges.size());
    // With this number of strips an edge is in about four of them.
    const int strips =
        rise > 0 ? static_cast<int>(std::clamp(4 * count * ((high - low) / rise), 1.0, count)) : 1;
    outline.stripLower = low;
    outline.stripHeight = (high - low) / strips;
    const auto stripOf = [&](double y) {
        return outline.stripHeight > 0
                   ? std::clamp(static_cast<int>((y - low) / outline.stripHeight), 0, strips - 1)
                   : 0;
    };
    outline.stripStart.assign(strips + 1, 0);
    for (int pass = 0; pass < 2; ++pass) {
        for (int i = 0; i < static_cast<int>(outline.edges.size()); ++i) {
            const Outline::Edge &e = outline.edges[i];
            if (e.winding == 0)
                continue;
            const auto [y0, y1] = std::minmax(outline.points[e.a].y(), outline.points[e.b].y());
            for (int s = stripOf(y0); s <= stripOf(y1); ++s) {
                if (pass == 0)
                    ++outline.stripStart[s + 1];
                else
                    outline.stripEdges[outline.stripStart[s]++] = i;
            }
        }
        if (pass == 0) {
            for (int s = 0; s < strips; ++s)
                outline.stripStart[s + 1] += outline.stripStart[s];
            outline.stripEdges.resize(outline.stripStart[strips]);
        }
    }
    for (int s = strips; s > 0; --s)
        outline.stripStart[s] = outline.stripStart[s - 1];
    outline.stripStart[0] = 0;
}

} // namespace

bool isUsablePoint(const Vec2 &point)
{
    // The comparisons are false for NaN.
    return std::abs(point.x()) < 1e100 && std::abs(point.y()) < 1e100;
}

double islandArea(const PackIsland &island)
{
    double area = 0;
    for (const auto &t : island.triangles) {
        const Vec2 &a = island.points[t[0]], &b = island.points[t[1]], &c = island.points[t[2]];
        if (isUsablePoint(a) && isUsablePoint(b) && isUsablePoint(c))
            area += 0.5 * std::abs(cross2(a, b, c));
    }
    return area;
}

Vec2 rotatedBox(const std::vector<Vec2> &hull, double angle)
{
    if (hull.empty())
        return Vec2::Zero();
    const double c = std::cos(angle), s = std::sin(angle);
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (const Vec2 &p : hull) {
        const Vec2 q(c * p.x() - s * p.y(), s * p.x() + c * p.y());
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
    }
    return high - low;
}

int Outline::windingAt(const Vec2 &p) const
{
    if (edges.empty())
        return 0;
    const int strips = static_cast<int>(stripStart.size()) - 1;
    const double offset = p.y() - stripLower;
    if (offset < 0 || offset > stripHeight * (strips + 1))
        return 0;
    const int strip = stripHeight > 0 ? std::clamp(static_cast<int>(offset / stripHeight), 0, strips - 1) : 0;
    int winding = 0;
    for (int i = stripStart[strip]; i < stripStart[strip + 1]; ++i) {
        const Edge &e = edges[stripEdges[i]];
        const Vec2 &a = points[e.a], &b = points[e.b];
        if (a.y() <= p.y() && b.y() > p.y()) {
            if (cross2(a, b, p) > 0)
                winding += e.winding;
        } else if (b.y() <= p.y() && a.y() > p.y()) {
            if (cross2(a, b, p) < 0)
                winding -= e.winding;
        }
    }
    return winding;
}

namespace {

//! Share of the border in two directions at a right angle from which an island stands upright, and by how
//! much, in degrees, the sides may differ from these.
constexpr double squareShare = 0.35;
constexpr int squareWidth = 1;

//! See Outline::squareAngle.
std::optional<double> squareAngleOf(const Outline &outline)
{
    constexpr int bins = 90; // of one degree
    constexpr double degree = 0.5 * std::numbers::pi / bins;
    struct Sides
    {
        double length = 0;
        Vec2 direction = Vec2::Zero(); //!< sum of unit vectors at four times the angle, by length
    };
    std::array<Sides, bins> sides;
    for (const Outline::Edge &edge : outline.edges) {
        const Vec2 side = outline.points[edge.b] - outline.points[edge.a];
        const double length = side.norm();
        if (!(length > 0))
            continue;
        const double angle = std::atan2(side.y(), side.x());
        const double turned = angle - 0.5 * std::numbers::pi * std::floor(angle / (0.5 * std::numbers::pi));
        Sides &own = sides[std::min(static_cast<int>(turned / degree), bins - 1)];
        own.length += length;
        own.direction += length * Vec2(std::cos(4 * angle), std::sin(4 * angle));
    }
    Sides best;
    for (int i = 0; i < bins; ++i) {
        Sides near;
        for (int k = -squareWidth; k <= squareWidth; ++k) {
            near.length += sides[(i + k + bins) % bins].length;
            near.direction += sides[(i + k + bins) % bins].direction;
        }
        if (near.length > best.length)
            best = near;
    }
    if (!(best.length >= squareShare * outline.perimeter) || outline.perimeter == 0)
        return std::nullopt;
    return -0.25 * std::atan2(best.direction.y(), best.direction.x());
}

} // namespace

bool standsOnAxes(const Outline &outline)
{
    constexpr double slope = 3e-3, share = 0.15; // chosen by hand; the borders of boxes have a share of 1
    double straight = 0;
    for (const Outline::Edge &edge : outline.edges) {
        const Vec2 side = (outline.points[edge.b] - outline.points[edge.a]).cwiseAbs();
        straight += side.minCoeff() <= slope * side.maxCoeff() ? side.norm() : 0;
    }
    return straight > 0 && straight >= share * outline.perimeter;
}

Outline makeOutline(const PackIsland &island, double unit)
{
    Outline outline;
    const std::vector<int> weld = weldPoints(island.points);
    std::vector<DirectedEdge> edges = shapeEdges(island, weld);
    if (edges.empty())
        edges = allEdges(island, weld);
    std::vector<int> local(weld.size(), -1);
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    const auto use = [&](int point) {
        if (local[point] < 0) {
            local[point] = static_cast<int>(outline.points.size());
            outline.points.push_back(island.points[point]);
            low = low.cwiseMin(island.points[point]);
            high = high.cwiseMax(island.points[point]);
        }
        return local[point];
    };
    for (const DirectedEdge &e : edges) {
        const int a = use(e.low);
        outline.edges.push_back({a, use(e.high), e.winding});
    }
    if (outline.points.empty())
        return outline;
    outline.centre = 0.5 * (low + high);
    UnionFind components(static_cast<int>(outline.points.size()));
    for (Vec2 &p : outline.points) {
        p = (p - outline.centre) / unit;
        outline.radius = std::max(outline.radius, p.norm());
    }
    for (const Outline::Edge &e : outline.edges) {
        components.unite(e.a, e.b);
        outline.perimeter += (outline.points[e.a] - outline.points[e.b]).norm();
    }
    for (int i = 0; i < static_cast<int>(outline.points.size()); ++i) {
        if (components.find(i) == i)
            outline.componentPoints.push_back(i);
    }
    outline.area = islandArea(island) / unit / unit;
    outline.hull = convexHull(outline.points);
    outline.boxAngle = leastBoxAngle(outline.hull);
    outline.squareAngle = squareAngleOf(outline);
    buildStrips(outline);
    return outline;
}

} // namespace autocuts::packing
