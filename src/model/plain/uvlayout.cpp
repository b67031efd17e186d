#include "model/plain/uvlayout.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

namespace autocuts {

namespace {

bool hasUv(const std::array<int, 3> &triangle, const UvMatrix &uv)
{
    return uv.row(triangle[0]).allFinite() && uv.row(triangle[1]).allFinite() &&
           uv.row(triangle[2]).allFinite();
}

double triangleUvArea(const std::array<int, 3> &triangle, const UvMatrix &uv)
{
    return 0.5 * std::abs(cross2(uv.row(triangle[0]), uv.row(triangle[1]), uv.row(triangle[2])));
}

} // namespace

UvMatrix emptyLayout(const MeshData &mesh)
{
    return UvMatrix::Constant(mesh.cornerCount(), 2, std::numeric_limits<double>::quiet_NaN());
}

UvMatrix soupUv(const MeshData &mesh, const UvMatrix &uv)
{
    UvMatrix soup(mesh.soupCornerCount(), 2);
    for (int s = 0; s < mesh.soupCornerCount(); ++s)
        soup.row(s) = uv.row(mesh.cornerOfSoup(s));
    return soup;
}

bool sameBits(const UvMatrix &a, const UvMatrix &b)
{
    return a.rows() == b.rows() &&
           (a.size() == 0 || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

Eigen::AlignedBox2d layoutBox(const UvMatrix &uv)
{
    Eigen::AlignedBox2d box;
    for (Eigen::Index i = 0; i < uv.rows(); ++i) {
        if (uv.row(i).allFinite())
            box.extend(Vec2(uv.row(i)));
    }
    return box;
}

double layoutScale(const MeshData &mesh, const UvMatrix &uv)
{
    double uvArea = 0;
    double area = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (!hasUv(mesh.triangles[t], uv))
            continue;
        uvArea += triangleUvArea(mesh.triangles[t], uv);
        area += mesh.targetArea(t);
    }
    const double scale = std::sqrt(uvArea / (area * std::numbers::pi / mesh.area));
    return std::isfinite(scale) && scale > 0 ? scale : defaultUvScale;
}

} // namespace autocuts
