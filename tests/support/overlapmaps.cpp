#include "support/overlapmaps.h"

#include "solver/overlap/predicates.h"

#include <cmath>
#include <numbers>

namespace autocuts::test {

using namespace overlap;

namespace {

std::array<Vec2, 3> turnedUp(const UvMatrix &uv, int t)
{
    std::array<Vec2, 3> p{uv.row(3 * t), uv.row(3 * t + 1), uv.row(3 * t + 2)};
    if (orientation(p[0], p[1], p[2]) < 0)
        std::swap(p[1], p[2]);
    return p;
}

} // namespace

std::vector<OverlapPair> bruteForce(const UvMatrix &uv, double minArea)
{
    std::vector<OverlapPair> pairs;
    const int count = static_cast<int>(uv.rows()) / 3;
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            const auto p = turnedUp(uv, a), q = turnedUp(uv, b);
            if (orientation(p[0], p[1], p[2]) == 0 || orientation(q[0], q[1], q[2]) == 0)
                continue;
            const double area = intersectionArea(p, q);
            if (area > minArea)
                pairs.push_back({a, b, area});
        }
    }
    return pairs;
}

UvMatrix mapped(const MeshData &mesh, const std::function<Vec2(const Vec3 &)> &map)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = map(mesh.cornerPosition(c)).transpose();
    return uv;
}

MeshPtr strip(int along, int across, bool quads)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int x = 0; x <= along; ++x) {
        for (int y = 0; y <= across; ++y)
            points.emplace_back(double(x) / along, 2.0 * y / across - 1, 0);
    }
    for (int x = 0; x < along; ++x) {
        for (int y = 0; y < across; ++y) {
            const int a = x * (across + 1) + y;
            const int b = a + across + 1;
            if (quads) {
                faces.push_back({a, b, b + 1, a + 1});
            } else {
                faces.push_back({a, b, b + 1});
                faces.push_back({a, b + 1, a + 1});
            }
        }
    }
    return polygonMesh(points, faces);
}

std::function<Vec2(const Vec3 &)> along(const std::function<Vec2(double)> &curve, double width)
{
    return [=](const Vec3 &p) -> Vec2 {
        const double step = 1e-6;
        const Vec2 tangent = (curve(p.x() + step) - curve(p.x() - step)).normalized();
        return curve(p.x()) + width * p.y() * Vec2(-tangent.y(), tangent.x());
    };
}

std::vector<OverlappingMap> overlappingMaps()
{
    const double pi = std::numbers::pi;
    const auto polar = [](double radius, double angle) {
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    std::vector<OverlappingMap> maps;
    const auto add = [&](const char *name, const MeshPtr &mesh, const std::function<Vec2(const Vec3 &)> &map,
                         int mostCharts) {
        maps.push_back({name, mesh, mapped(*mesh, map), mostCharts});
    };
    add("spiral", strip(120, 3, false), along([=](double s) { return polar(1 + 0.6 * s, 6 * pi * s); }, 0.3),
        6);
    add("spiral of quads", strip(120, 3, true),
        along([=](double s) { return polar(1 + 0.6 * s, 6 * pi * s); }, 0.3), 6);
    add("crossing loop", strip(80, 2, false),
        along([=](double s) { return Vec2(std::sin(1.9 * pi * s + 0.3), std::sin(3.8 * pi * s + 0.6)); },
              0.08),
        3);
    add("folded back", strip(40, 2, true),
        along([=](double s) { return polar(1 + 0.1 * s, 2.4 * pi * s); }, 0.2), 3);
    add("stacked layers", strip(96, 2, true), along([=](double s) { return polar(1, 8 * pi * s); }, 0.3), 5);
    add("lid over itself", strip(30, 6, false),
        along([=](double s) { return polar(1, 1.97 * pi * s); }, 0.999), 1);
    // The end of the strip lies inside its beginning, chart-in-chart.
    add(
        "tail in the head", strip(60, 4, false),
        [=](const Vec3 &p) {
            const double width = p.x() < 0.3 ? 0.5 : 0.1;
            return Vec2(along([=](double s) { return polar(1, 2.2 * pi * s); }, width)(p));
        },
        3);
    return maps;
}

} // namespace autocuts::test
