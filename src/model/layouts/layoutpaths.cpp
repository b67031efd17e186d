#include "model/layouts/layoutpaths.h"

#include "model/plain/chart.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>

namespace autocuts {

namespace {

using Loop = LayoutPaths::Loop;

//! The drawn region of UV space. Drawing far outside the picture is slow and may overflow; the picture is the
//! first tile, and a border of one unit keeps line ends out of sight. Chosen by hand.
Eigen::AlignedBox2d drawnRegion(double tileHeight)
{
    return {Vec2(-1, -1), Vec2(2, tileHeight + 1)};
}

//! A side of a face or triangle with a direction.
struct DirectedSide
{
    int chart, from, to; //!< chart, and UV vertices at the start and the end

    auto edge() const { return std::tuple(chart, std::min(from, to), std::max(from, to)); }
    bool operator<(const DirectedSide &o) const
    {
        return std::tie(chart, from, to) < std::tie(o.chart, o.from, o.to);
    }
};

//! The sides of all triangles. Flipped triangles are reversed, so that all run counter-clockwise.
std::vector<DirectedSide> triangleSides(const MeshData &mesh, const UvMatrix &uv, const UvTopology &topology)
{
    std::vector<DirectedSide> sides;
    sides.reserve(mesh.soupCornerCount());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (!topology.faceHasUv[face])
            continue;
        std::array<int, 3> root{};
        for (int k = 0; k < 3; ++k)
            root[k] = topology.cornerRoot[mesh.triangles[t][k]];
        if (cross2(uv.row(root[0]), uv.row(root[1]), uv.row(root[2])) < 0)
            std::swap(root[1], root[2]);
        for (int k = 0; k < 3; ++k) {
            if (root[k] != root[(k + 1) % 3])
                sides.push_back({topology.charts.faceChart[face], root[k], root[(k + 1) % 3]});
        }
    }
    return sides;
}

//! Removes pairs of sides that run in opposite directions along one edge. Since every triangle is a closed
//! loop, equally many of the remaining sides start and end at each UV vertex.
std::vector<DirectedSide> cancelled(std::vector<DirectedSide> sides)
{
    std::sort(sides.begin(), sides.end(),
              [](const DirectedSide &a, const DirectedSide &b) { return a.edge() < b.edge(); });
    std::vector<DirectedSide> left;
    for (std::size_t i = 0; i < sides.size();) {
        int forward = 0;
        std::size_t j = i;
        for (; j < sides.size() && sides[j].edge() == sides[i].edge(); ++j)
            forward += sides[j].from < sides[j].to ? 1 : -1;
        const auto [chart, low, high] = sides[i].edge();
        for (; forward > 0; --forward)
            left.push_back({chart, low, high});
        for (; forward < 0; ++forward)
            left.push_back({chart, high, low});
        i = j;
    }
    std::sort(left.begin(), left.end());
    return left;
}

//! The sides of faces on the borders of their charts, in the winding of the faces.
std::vector<DirectedSide> borderSides(const MeshData &mesh, const UvTopology &topology)
{
    std::vector<DirectedSide> sides, border;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (!topology.faceHasUv[f])
            continue;
        const int start = mesh.faceStart[f];
        const int n = mesh.faceStart[f + 1] - start;
        for (int i = 0; i < n; ++i)
            sides.push_back({topology.charts.faceChart[f], topology.cornerRoot[start + i],
                             topology.cornerRoot[start + (i + 1) % n]});
    }
    std::sort(sides.begin(), sides.end(),
              [](const DirectedSide &a, const DirectedSide &b) { return a.edge() < b.edge(); });
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const bool alone = (i == 0 || sides[i - 1].edge() != sides[i].edge()) &&
                           (i + 1 == sides.size() || sides[i + 1].edge() != sides[i].edge());
        if (alone)
            border.push_back(sides[i]);
    }
    std::sort(border.begin(), border.end());
    return border;
}

//! A sequence of sides, each starting where the previous one ends.
struct Chain
{
    int chart;
    std::vector<int> vertices;
    bool closed;
};

//! \param sides sorted
std::vector<Chain> chains(const std::vector<DirectedSide> &sides)
{
    std::vector<bool> used(sides.size(), false);
    const auto nextFrom = [&](int chart, int vertex) {
        auto side = std::lower_bound(sides.begin(), sides.end(), DirectedSide{chart, vertex, -1});
        while (side != sides.end() && side->chart == chart && side->from == vertex &&
               used[side - sides.begin()])
            ++side;
        const bool found = side != sides.end() && side->chart == chart && side->from == vertex;
        return found ? static_cast<std::size_t>(side - sides.begin()) : sides.size();
    };
    std::vector<Chain> result;
    for (std::size_t first = 0; first < sides.size(); ++first) {
        if (used[first])
            continue;
        Chain chain{sides[first].chart, {sides[first].from}, false};
        for (std::size_t side = first; side < sides.size() && !chain.closed;) {
            used[side] = true;
            chain.closed = sides[side].to == sides[first].from;
            if (!chain.closed)
                chain.vertices.push_back(sides[side].to);
            side = nextFrom(chain.chart, sides[side].to);
        }
        result.push_back(std::move(chain));
    }
    return result;
}

bool isNear(const Loop &points, const Eigen::AlignedBox2d &region)
{
    return std::all_of(points.begin(), points.end(), [&](const Vec2 &p) { return region.contains(p); });
}

//! The part of a polygon on one side of an axis-parallel line.
Loop clippedHalf(const Loop &loop, int axis, double limit, bool keepBelow)
{
    const auto inside = [&](const Vec2 &p) { return keepBelow ? p[axis] <= limit : p[axis] >= limit; };
    Loop result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &p = loop[i];
        const Vec2 &q = loop[(i + 1) % loop.size()];
        if (inside(p))
            result.push_back(p);
        if (inside(p) != inside(q)) {
            Vec2 crossing = p + (limit - p[axis]) / (q[axis] - p[axis]) * (q - p);
            crossing[axis] = limit;
            result.push_back(crossing);
        }
    }
    return result;
}

Loop clippedLoop(Loop loop, const Eigen::AlignedBox2d &region)
{
    if (isNear(loop, region))
        return loop;
    for (int axis = 0; axis < 2; ++axis) {
        for (const bool keepBelow : {false, true})
            loop = clippedHalf(loop, axis, (keepBelow ? region.max() : region.min())[axis], keepBelow);
    }
    return loop;
}

//! Clips a line to the drawn region; false when nothing is left.
bool clipLine(Vec2 &a, Vec2 &b, const Eigen::AlignedBox2d &region)
{
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {1, -1}) {
            const double limit = (sign > 0 ? region.min() : region.max())[axis];
            const bool aOut = sign * (a[axis] - limit) < 0;
            const bool bOut = sign * (b[axis] - limit) < 0;
            if (aOut && bOut)
                return false;
            if (!aOut && !bOut)
                continue;
            const Vec2 crossing = a + (limit - a[axis]) / (b[axis] - a[axis]) * (b - a);
            (aOut ? a : b) = crossing;
        }
    }
    return true;
}

Loop places(const UvMatrix &uv, const std::vector<int> &vertices)
{
    Loop points;
    points.reserve(vertices.size());
    for (int v : vertices)
        points.emplace_back(uv.row(v));
    return points;
}

void addBorders(const UvMatrix &uv, const std::vector<DirectedSide> &border,
                const Eigen::AlignedBox2d &region, LayoutPaths &paths)
{
    for (const Chain &chain : chains(border)) {
        Loop points = places(uv, chain.vertices);
        if (isNear(points, region)) {
            paths.borders.push_back({std::move(points), chain.closed});
            continue;
        }
        for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < points.size(); ++i) {
            Vec2 a = points[i];
            Vec2 b = points[(i + 1) % points.size()];
            if (clipLine(a, b, region))
                paths.borders.push_back({{a, b}, false});
        }
    }
}

//! A triangle, counter-clockwise; empty where it is outside of the region.
Loop triangleLoop(const MeshData &mesh, const UvMatrix &uv, int triangle, const Eigen::AlignedBox2d &region)
{
    Loop loop;
    for (int corner : mesh.triangles[triangle])
        loop.emplace_back(uv.row(corner));
    if (cross2(loop[0], loop[1], loop[2]) < 0)
        std::swap(loop[1], loop[2]);
    return clippedLoop(std::move(loop), region);
}

//! Outlines that cross themselves all over take painters long: such islands get a loop for each triangle.
void breakUpTangles(const MeshData &mesh, const UvMatrix &uv, const UvTopology &topology,
                    const Eigen::AlignedBox2d &region, LayoutPaths &paths)
{
    constexpr std::size_t longOutline = 500; // points. Chosen by hand
    std::vector<bool> &isTangle = paths.isTangle;
    isTangle.assign(paths.islands.size(), false);
    std::vector<std::size_t> points(paths.islands.size(), 0);
    for (std::size_t chart = 0; chart < paths.islands.size(); ++chart) {
        for (const Loop &loop : paths.islands[chart])
            points[chart] += loop.size();
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (!topology.faceHasUv[face])
            continue;
        const auto &[a, b, c] = mesh.triangles[t];
        const auto chart = static_cast<std::size_t>(topology.charts.faceChart[face]);
        if (points[chart] > longOutline && cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c))) < 0)
            isTangle[chart] = true;
    }
    for (std::size_t chart = 0; chart < paths.islands.size(); ++chart) {
        if (isTangle[chart])
            paths.islands[chart].clear();
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (!topology.faceHasUv[face] || !isTangle[topology.charts.faceChart[face]])
            continue;
        if (Loop loop = triangleLoop(mesh, uv, t, region); !loop.empty())
            paths.islands[topology.charts.faceChart[face]].push_back(std::move(loop));
    }
}

} // namespace

LayoutPaths layoutPaths(const MeshData &mesh, const UvMatrix &uv, double tileHeight,
                        const std::vector<int> &overlapping)
{
    const Eigen::AlignedBox2d region = drawnRegion(tileHeight);
    const UvTopology topology = findUvTopology(mesh, uv);
    LayoutPaths paths;
    paths.islands.resize(topology.charts.count);
    for (const Chain &chain : chains(cancelled(triangleSides(mesh, uv, topology)))) {
        Loop loop = clippedLoop(places(uv, chain.vertices), region);
        if (!loop.empty())
            paths.islands[chain.chart].push_back(std::move(loop));
    }
    breakUpTangles(mesh, uv, topology, region, paths);
    addBorders(uv, borderSides(mesh, topology), region, paths);
    for (const UvEdge &edge : topology.uvEdges) {
        Vec2 a = uv.row(topology.cornerRoot[edge.corner[0]]);
        Vec2 b = uv.row(topology.cornerRoot[edge.corner[1]]);
        if (!edge.open && clipLine(a, b, region))
            paths.innerEdges.emplace_back(a, b);
    }
    for (int t : overlapping) {
        if (t < 0 || t >= mesh.triangleCount() || !topology.faceHasUv[mesh.triangleFace[t]])
            continue;
        if (Loop loop = triangleLoop(mesh, uv, t, region); !loop.empty())
            paths.overlaps.push_back(std::move(loop));
    }
    return paths;
}

} // namespace autocuts
