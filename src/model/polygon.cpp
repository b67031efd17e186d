#include "model/polygon.h"

#include <Eigen/Geometry>

#include <limits>

namespace autocuts {

Vec3 polygonNormal(const std::vector<Vec3> &points)
{
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        normal += (points[i] - points[0]).cross(points[i + 1] - points[0]);
    return normal;
}

int fanApex(const std::vector<Vec3> &points)
{
    const int n = static_cast<int>(points.size());
    const Vec3 normal = polygonNormal(points);
    for (int apex = 0; apex < n; ++apex) {
        bool good = true;
        for (int i = 1; i + 1 < n && good; ++i) {
            const Vec3 a = points[(apex + i) % n] - points[apex];
            const Vec3 b = points[(apex + i + 1) % n] - points[apex];
            const Vec3 turn = a.cross(b);
            // Summed from x to z: for points in one line only rounding decides, and it has to decide
            // the same everywhere.
            good = turn.x() * normal.x() + turn.y() * normal.y() + turn.z() * normal.z() >= 0;
        }
        if (good)
            return apex;
    }
    return -1;
}

namespace {

std::vector<Vec2> projected(const std::vector<Vec3> &points)
{
    const Vec3 normal = polygonNormal(points);
    int drop = 0;
    normal.cwiseAbs().maxCoeff(&drop);
    const int x = (drop + 1) % 3;
    const int y = (drop + 2) % 3;
    std::vector<Vec2> flat;
    flat.reserve(points.size());
    for (const Vec3 &p : points)
        flat.emplace_back(p[x], p[y]);
    if (normal[drop] < 0) {
        for (Vec2 &p : flat)
            p.x() = -p.x();
    }
    return flat;
}

bool insideTriangle(const Vec2 &p, const Vec2 &a, const Vec2 &b, const Vec2 &c)
{
    return cross2(a, b, p) >= 0 && cross2(b, c, p) >= 0 && cross2(c, a, p) >= 0;
}

} // namespace

std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3> &points)
{
    const int n = static_cast<int>(points.size());
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(n - 2);
    if (n == 3)
        return {{0, 1, 2}};
    const int apex = fanApex(points);
    if (apex >= 0) {
        for (int i = 1; i + 1 < n; ++i)
            triangles.push_back({apex, (apex + i) % n, (apex + i + 1) % n});
        return triangles;
    }

    const std::vector<Vec2> flat = projected(points);
    std::vector<int> left(n);
    for (int i = 0; i < n; ++i)
        left[i] = i;
    while (left.size() > 3) {
        const int m = static_cast<int>(left.size());
        int best = 0;
        double bestScore = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < m; ++i) {
            const Vec2 &a = flat[left[(i + m - 1) % m]];
            const Vec2 &b = flat[left[i]];
            const Vec2 &c = flat[left[(i + 1) % m]];
            const double area = cross2(a, b, c);
            bool ear = area > 0;
            for (int k = 2; k + 1 < m && ear; ++k) {
                const Vec2 &p = flat[left[(i + k) % m]];
                ear = p == a || p == b || p == c || !insideTriangle(p, a, b, c);
            }
            const double longest =
                std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            // The roundest ear; when no ear is left (a self-crossing polygon), the least bad corner.
            const double score = longest > 0 ? area / longest + (ear ? 10 : 0) : 5;
            if (score > bestScore) {
                bestScore = score;
                best = i;
            }
        }
        triangles.push_back({left[(best + m - 1) % m], left[best], left[(best + 1) % m]});
        left.erase(left.begin() + best);
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

} // namespace autocuts
