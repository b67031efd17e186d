#include "views/canvas/mappicker.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

bool contains(const Vec2 &a, const Vec2 &b, const Vec2 &c, const Vec2 &p)
{
    const double ab = cross2(a, b, p), bc = cross2(b, c, p), ca = cross2(c, a, p);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

//! The nearest of several candidates. Among equally near ones, the one of the triangle under the mouse, or
//! else the last.
struct Nearest
{
    double distance = pickRadius;
    int soup = -1;

    void offer(double offered, int item, int preferredTriangle)
    {
        // The two sides of a stitched edge have the same position up to rounding.
        constexpr double same = 1e-6;
        if (offered > distance + same)
            return;
        if (offered > distance - same && soup >= 0 && soup / 3 == preferredTriangle)
            return;
        distance = std::min(distance, offered);
        soup = item;
    }
};

} // namespace

PickResult pickMap(const MeshData &mesh, const SoupTopology &topology, const UvMatrix &uv,
                   const MapCamera &camera, const QPointF &pixel)
{
    const Vec2 mouse = camera.toUv(pixel);
    const double reach = pickRadius / camera.scale();
    PickResult result;
    std::vector<int> around; // triangle indices
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec2 a = uv.row(3 * t), b = uv.row(3 * t + 1), c = uv.row(3 * t + 2);
        const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        // Written so that it is false for NaN coordinates.
        if (!((low.array() <= mouse.array() + reach).all() && (high.array() >= mouse.array() - reach).all()))
            continue;
        if (!uv.middleRows(3 * t, 3).allFinite())
            continue;
        around.push_back(t);
        if (contains(a, b, c, mouse) && cross2(a, b, c) != 0)
            result.triangle = t;
    }
    Nearest side, corner;
    for (int t : around) {
        for (int s = 3 * t; s < 3 * t + 3; ++s) {
            const Vec2 a = (Vec2(uv.row(s)) - mouse) * camera.scale();
            const Vec2 b = (Vec2(uv.row(nextSoupCorner(s))) - mouse) * camera.scale();
            corner.offer(a.norm(), s, result.triangle);
            if (topology.sideEdge[s] >= 0)
                side.offer(nearestOnSegment(0, 0, a.x(), a.y(), b.x(), b.y()).distance, s, result.triangle);
        }
    }
    result.side = side.soup;
    result.edge = side.soup < 0 ? -1 : topology.sideEdge[side.soup];
    result.soupCorner = corner.soup;
    result.corner = corner.soup < 0 ? -1 : mesh.cornerOfSoup(corner.soup);
    return result;
}

BoxPick pickMapBox(const MeshData &mesh, const SoupTopology &topology, const UvMatrix &uv,
                   const MapCamera &camera, const PickRegion &region)
{
    const Vec2 low = camera.toUv(region.box.bottomLeft()), high = camera.toUv(region.box.topRight());
    const auto inside = [&](const Vec2 &p) {
        return (p.array() >= low.array()).all() && (p.array() <= high.array()).all() &&
               (!region.inside || region.inside(camera.toScreen(p)));
    };
    BoxPick result;
    std::vector<bool> cornerInside(mesh.cornerCount()), edgeInside(topology.edgeSides.size());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Vec2 sum = Vec2::Zero();
        int count = 0;
        for (const int s : mesh.soupCornersOf(f)) {
            const Vec2 a = uv.row(s), b = uv.row(nextSoupCorner(s));
            sum += a;
            ++count;
            if (inside(a))
                cornerInside[mesh.cornerOfSoup(s)] = true;
            if (topology.sideEdge[s] >= 0 && inside(0.5 * (a + b)))
                edgeInside[topology.sideEdge[s]] = true;
        }
        if (inside(sum / count))
            result.faces.push_back(f);
    }
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        if (cornerInside[c])
            result.corners.push_back(c);
    }
    for (std::size_t e = 0; e < edgeInside.size(); ++e) {
        if (edgeInside[e])
            result.edges.push_back(static_cast<int>(e));
    }
    return result;
}

} // namespace autocuts
