#include "support/meshbuilders.h"

#include "model/samples/samples.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

namespace autocuts::test {

MeshPtr polygonMesh(const std::vector<Vec3> &points, const std::vector<std::vector<int>> &faces)
{
    PositionMatrix positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        positions.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    std::vector<int> start{0}, corners;
    for (const auto &face : faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        start.push_back(static_cast<int>(corners.size()));
    }
    return MeshData::build(std::move(positions), std::move(start), std::move(corners),
                           std::vector<int>(faces.size(), 0));
}

MeshPtr triangle()
{
    return polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 1, 0}});
}

namespace {

std::vector<Vec3> cubePoints()
{
    return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
}

const std::vector<std::vector<int>> cubeQuads{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

} // namespace

MeshPtr cube()
{
    std::vector<std::vector<int>> faces;
    for (const auto &q : cubeQuads) {
        faces.push_back({q[0], q[1], q[2]});
        faces.push_back({q[0], q[2], q[3]});
    }
    return polygonMesh(cubePoints(), faces);
}

MeshPtr quadCube()
{
    return polygonMesh(cubePoints(), cubeQuads);
}

MeshPtr grid(int n, double height)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x) {
            const double u = double(x) / n;
            const double v = double(y) / n;
            points.emplace_back(u, v,
                                height * std::sin(std::numbers::pi * u) * std::sin(std::numbers::pi * v));
        }
    }
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x;
            faces.push_back({a, a + 1, a + n + 2, a + n + 1});
        }
    }
    return polygonMesh(points, faces);
}

MeshPtr sphere(int rings, int segments)
{
    std::vector<Vec3> points{{0, 0, 1}};
    std::vector<std::vector<int>> faces;
    for (int r = 1; r < rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            const double theta = std::numbers::pi * r / rings;
            const double phi = 2 * std::numbers::pi * s / segments;
            points.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                std::cos(theta));
        }
    }
    points.emplace_back(0, 0, -1);
    const int last = static_cast<int>(points.size()) - 1;
    const auto at = [&](int r, int s) { return 1 + (r - 1) * segments + s % segments; };
    for (int s = 0; s < segments; ++s) {
        faces.push_back({0, at(1, s), at(1, s + 1)});
        for (int r = 1; r + 1 < rings; ++r) {
            faces.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            faces.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
        faces.push_back({last, at(rings - 1, s + 1), at(rings - 1, s)});
    }
    return polygonMesh(points, faces);
}

MeshPtr turnedSphere(int rings, int segments)
{
    const MeshPtr whole = sphere(rings, segments);
    std::vector<Vec3> points;
    for (int v = 0; v < whole->vertexCount(); ++v)
        points.emplace_back(whole->positions.row(v));
    std::vector<std::vector<int>> faces;
    for (int face = 0; face < whole->faceCount(); ++face) {
        std::vector<int> corners(whole->cornerVertex.begin() + whole->faceStart[face],
                                 whole->cornerVertex.begin() + whole->faceStart[face + 1]);
        double height = 0;
        for (const int v : corners)
            height += points[v].z();
        if (height < 0)
            std::reverse(corners.begin(), corners.end());
        faces.push_back(std::move(corners));
    }
    return polygonMesh(points, faces);
}

MeshPtr torus(int major, int minor)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int i = 0; i < major; ++i) {
        for (int j = 0; j < minor; ++j) {
            const double a = 2 * std::numbers::pi * i / major;
            const double b = 2 * std::numbers::pi * j / minor;
            const double r = 1 + 0.4 * std::cos(b);
            points.emplace_back(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
        }
    }
    const auto at = [&](int i, int j) { return (i % major) * minor + j % minor; };
    for (int i = 0; i < major; ++i) {
        for (int j = 0; j < minor; ++j)
            faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    return polygonMesh(points, faces);
}

MeshPtr dirty()
{
    std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0},  {2, 0, 0},  {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 0, 1},
                             {1, 1, 1}, {1, 0, -1}, {1, 1, -1}, {0, 2, 0}, {1, 2, 0}, {9, 9, 9}, {1, 1, 0}};
    for (Vec3 &p : points)
        p += Vec3(40000, -70000, 10000);
    return polygonMesh(points, {{0, 1, 4, 3}, // a strip of two quads ...
                                {1, 2, 5, 4},
                                {1, 6, 7, 4}, // ... and two more on the edge between them
                                {4, 9, 8, 1},
                                {2, 5, 4, 1}, // the second quad once more
                                {3, 13, 10},  // joined through the double of vertex 4
                                {13, 10, 11}, // wound the wrong way
                                {0, 3, 3},    // a side of no length
                                {2, 1, 0}});  // no height
}

MeshPtr meshNamed(const QString &name)
{
    if (name == QLatin1String("triangle"))
        return triangle();
    if (name == QLatin1String("cube"))
        return cube();
    if (name == QLatin1String("quad cube"))
        return quadCube();
    if (name == QLatin1String("grid"))
        return grid(5, 0.3);
    if (name == QLatin1String("sphere"))
        return sphere(6, 8);
    if (name == QLatin1String("turned sphere"))
        return turnedSphere(6, 8);
    if (name == QLatin1String("torus"))
        return torus(8, 6);
    if (name == QLatin1String("dirty"))
        return dirty();
    return makeSample(name).value().mesh;
}

std::string meshFolder()
{
    namespace fs = std::filesystem;
    if (const char *folder = std::getenv("AUTOCUTS_MESHES"))
        return fs::is_directory(folder) ? folder : "";
    const fs::path beside = fs::path(AUTOCUTS_SOURCE_DIR) / ".." / "shared" / "meshes";
    return fs::is_directory(beside) ? beside.lexically_normal().string() : "";
}

} // namespace autocuts::test
