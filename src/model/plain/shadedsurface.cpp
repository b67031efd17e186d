#include "model/plain/shadedsurface.h"

#include <Eigen/Geometry>

#include <cmath>

namespace autocuts {

const Picture *TiledPicture::at(const Vec2 &uv) const
{
    constexpr int firstTile = 1001, columns = 10;
    const double column = std::floor(uv.x()), row = std::floor(uv.y());
    if (!tiles.empty() && column >= 0 && column < columns && row >= 0 && row < 900) {
        const auto found = tiles.find(firstTile + static_cast<int>(column) + columns * static_cast<int>(row));
        if (found != tiles.end())
            return found->second.get();
    }
    return repeated.get();
}

Vec3 ShadedSurface::position(const SurfacePoint &point) const
{
    const auto &corners = mesh->triangles[point.triangle];
    const auto at = [&](int k) { return mesh->cornerPosition(corners[k]); };
    return point.between<Vec3>(at(0), at(1), at(2));
}

Vec3f ShadedSurface::faceNormal(int triangle) const
{
    const auto &corners = mesh->triangles[triangle];
    const Vec3 a = mesh->cornerPosition(corners[0]);
    const Vec3 normal =
        (mesh->cornerPosition(corners[1]) - a).cross(mesh->cornerPosition(corners[2]) - a).stableNormalized();
    return normal.allFinite() ? Vec3f(normal.cast<float>()) : Vec3f(Vec3f::Zero());
}

Vec3f ShadedSurface::shadingNormal(const SurfacePoint &point) const
{
    const auto &corners = mesh->triangles[point.triangle];
    const Vec3f normal = point.between<Vec3f>(normals[corners[0]], normals[corners[1]], normals[corners[2]])
                             .stableNormalized();
    return normal.squaredNorm() > 0.5F ? normal : faceNormal(point.triangle);
}

Vec2 ShadedSurface::uvAt(const SurfacePoint &point) const
{
    const auto &corners = mesh->triangles[point.triangle];
    const Vec2 a = uv.row(corners[0]), b = uv.row(corners[1]), c = uv.row(corners[2]);
    return a + double(point.second) * (b - a) + double(point.third) * (c - a);
}

Eigen::Matrix3f ShadedSurface::tangentFrame(const SurfacePoint &point) const
{
    const auto &corners = mesh->triangles[point.triangle];
    const auto tangent = [&](int k) -> const Tangent & { return tangents[3 * point.triangle + k]; };
    Eigen::Matrix3f frame;
    frame.col(2) = point.between<Vec3f>(normals[corners[0]], normals[corners[1]], normals[corners[2]]);
    frame.col(0) = point.between<Vec3f>(tangent(0).direction, tangent(1).direction, tangent(2).direction);
    frame.col(1) = tangent(0).sign * frame.col(2).cross(frame.col(0));
    return frame;
}

int ShadedSurface::materialOf(int triangle) const
{
    return faceMaterial.empty() ? -1 : faceMaterial[mesh->triangleFace[triangle]];
}

} // namespace autocuts
