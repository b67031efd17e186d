#include "solver/rigid/surfaceshape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::rigid {

namespace {

//! Height of a thin triangle, as a share of its longest edge.
constexpr double thinHeight = 2e-3;
//! Angle defect (radians) that counts as none: a part for the precision of files, which grows in thin
//! triangles, and a share of the defect that a sphere of the same area would have there.
constexpr double flatDefect = 3e-4, digits = 2e-6, mostFlatDefect = 0.02, sphereShare = 0.02;

Vec3 position(const MeshData &mesh, int soupCorner)
{
    return mesh.cornerPosition(mesh.cornerOfSoup(soupCorner));
}

} // namespace

SurfaceShape::SurfaceShape(const MeshData &mesh) : uncut(mesh, CutFlags(mesh.edgePairs.size(), false))
{
    measureTriangles(mesh);
    measureVertices(mesh);
}

double SurfaceShape::planeCosine()
{
    return std::cos(std::numbers::pi / 180);
}

void SurfaceShape::measureTriangles(const MeshData &mesh)
{
    const int count = mesh.triangleCount();
    normal.assign(count, Vec3::Zero());
    thin.assign(count, false);
    Vec3 low = position(mesh, 0), high = low;
    for (int t = 0; t < count; ++t) {
        const Vec3 a = position(mesh, 3 * t), b = position(mesh, 3 * t + 1), c = position(mesh, 3 * t + 2);
        low = low.cwiseMin(a).cwiseMin(b).cwiseMin(c);
        high = high.cwiseMax(a).cwiseMax(b).cwiseMax(c);
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        normal[t] = (b - a).cross(c - a).stableNormalized();
        thin[t] = mesh.triangleDegenerate[t] || 2 * mesh.triangleArea[t] < thinHeight * longest * longest;
    }
    size = (high - low).norm();
    for (int t = 0; t < mesh.triangleCount(); ++t)
        wholeArea += mesh.copiesOf(t) * mesh.triangleArea[t];
    for (int f = 0; f < mesh.faceCount(); ++f)
        wholeFaces += mesh.faceCopies.empty() ? 1 : mesh.faceCopies[f];
    flattenPolygons(mesh);
}

//! The triangles of a polygon get its normal where it is plane; others are in no flat region.
void SurfaceShape::flattenPolygons(const MeshData &mesh)
{
    planeFace.assign(mesh.faceCount(), true);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Vec3 sum = Vec3::Zero();
        for (const int t : mesh.trianglesOf(f))
            sum += mesh.triangleArea[t] * normal[t];
        const Vec3 common = sum.stableNormalized();
        for (const int t : mesh.trianglesOf(f)) {
            if (!thin[t] && common.dot(normal[t]) <= planeCosine())
                planeFace[f] = false;
        }
        for (const int t : mesh.trianglesOf(f)) {
            if (!planeFace[f])
                break;
            normal[t] = common;
            thin[t] = thin[t] && mesh.trianglesOf(f).size() == 1;
        }
    }
}

//! Angle defects of the vertices of the uncut surface, and what counts as none there.
void SurfaceShape::measureVertices(const MeshData &mesh)
{
    const int count = uncut.uvVertexCount;
    std::vector<double> angle(count, 0), area(count, 0);
    std::vector<double> least(count, size); // height of the thinnest triangle
    inner.assign(count, true);
    for (int side = 0; side < mesh.soupCornerCount(); ++side) {
        const int t = side / 3, next = 3 * t + (side + 1) % 3, last = 3 * t + (side + 2) % 3;
        const int v = uncut.uvVertex[side];
        if (uncut.neighbour[side] < 0)
            inner[v] = inner[uncut.uvVertex[next]] = false;
        const Vec3 a = position(mesh, next) - position(mesh, side),
                   b = position(mesh, last) - position(mesh, side);
        angle[v] += std::atan2(a.cross(b).norm(), a.dot(b));
        area[v] += mesh.triangleArea[t] / 3;
        least[v] = std::min(least[v], 2 * mesh.triangleArea[t] /
                                          std::max({a.norm(), b.norm(), (a - b).norm(), 1e-300}));
    }
    defect.resize(count);
    flatPoint.resize(count);
    for (int v = 0; v < count; ++v) {
        defect[v] = 2 * std::numbers::pi - angle[v];
        const double precision = flatDefect + digits * size / std::max(least[v], 1e-300);
        const double sphere = 4 * std::numbers::pi * area[v] / wholeArea;
        flatPoint[v] =
            std::abs(defect[v]) <= std::max(std::min(precision, mostFlatDefect), sphereShare * sphere);
    }
}

} // namespace autocuts::rigid
