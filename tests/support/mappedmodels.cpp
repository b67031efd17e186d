#include "support/mappedmodels.h"

#include <cmath>
#include <numbers>

namespace autocuts::test {

MappedModel mapped(const MeshPtr &mesh, const MapOf &map)
{
    MappedModel result{mesh, UvMatrix(mesh->cornerCount(), 2)};
    for (int f = 0; f < mesh->faceCount(); ++f) {
        Vec3 centre = Vec3::Zero();
        const int first = mesh->faceStart[f], end = mesh->faceStart[f + 1];
        for (int c = first; c < end; ++c)
            centre += mesh->cornerPosition(c) / (end - first);
        for (int c = first; c < end; ++c)
            result.uv.row(c) = map(mesh->cornerPosition(c), centre);
    }
    return result;
}

MeshPtr box(int n, const Vec3 &size, bool triangles)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2, first = static_cast<int>(points.size());
        const double sign = side % 2 == 0 ? 1 : -1;
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n; ++j) {
                Vec3 p;
                p[axis] = sign;
                p[(axis + 1) % 3] = -1 + 2.0 * (sign > 0 ? i : n - i) / n;
                p[(axis + 2) % 3] = -1 + 2.0 * j / n;
                points.push_back(0.5 * p.cwiseProduct(size));
            }
        }
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                const int a = first + i * (n + 1) + j, b = a + n + 1;
                if (triangles) {
                    faces.push_back({a, b, b + 1});
                    faces.push_back({a, b + 1, a + 1});
                } else {
                    faces.push_back({a, b, b + 1, a + 1});
                }
            }
        }
    }
    return polygonMesh(points, faces);
}

MapOf boxMap(const Vec3 &size)
{
    return [size](const Vec3 &point, const Vec3 &centre) -> Vec2 {
        int axis = 0;
        centre.cwiseQuotient(size).cwiseAbs().maxCoeff(&axis);
        const double sign = centre[axis] > 0 ? 1 : -1;
        return {0.2 + 0.3 * axis + 0.1 * sign * point[(axis + 1) % 3],
                (sign > 0 ? 0.2 : 0.5) + 0.1 * point[(axis + 2) % 3]};
    };
}

MeshPtr tube(int segments, int rings, double angle)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            const double at = angle + 2 * std::numbers::pi * s / segments;
            points.push_back({std::cos(at), std::sin(at), -1 + 2.0 * r / rings});
        }
    }
    for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            const int a = r * segments + s, b = r * segments + (s + 1) % segments;
            faces.push_back({a, b, b + segments, a + segments});
        }
    }
    return polygonMesh(points, faces);
}

Vec2 tubeMap(const Vec3 &point, const Vec3 &centre)
{
    constexpr double turn = 2 * std::numbers::pi;
    const auto angleOf = [](const Vec3 &p) {
        const double angle = std::atan2(p.y(), p.x());
        return angle < 0 ? angle + turn : angle;
    };
    const double middle = angleOf(centre);
    double angle = angleOf(point);
    if (angle - middle > turn / 2)
        angle -= turn;
    if (middle - angle > turn / 2)
        angle += turn;
    return {angle, point.z()};
}

Vec2 halvesMap(const Vec3 &point, const Vec3 &centre)
{
    const double sign = centre.z() > 0 ? 1 : -1;
    // Stereographic from the other pole: angles stay, and nothing is smaller than half its size.
    const double scale = 2 / (1 + sign * point.z());
    return {(sign > 0 ? 0 : 10) + sign * scale * point.x(), scale * point.y()};
}

} // namespace autocuts::test
