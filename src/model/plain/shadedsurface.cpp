#include "model/plain/shadedsurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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

const Picture *ShadedSurface::pictureAt(int texture, const SurfacePoint &point, Vec2 &at) const
{
    if (texture >= std::ssize(textures) || textures[texture].ofMaterial.empty() || uv.rows() == 0)
        return nullptr;
    at = uvAt(point);
    at.y() /= tileHeight;
    if (!at.allFinite())
        return nullptr;
    const auto &pictures = textures[texture].ofMaterial;
    const int material = materialOf(point.triangle);
    const std::size_t last = pictures.size() - 1;
    const Picture *picture = pictures[material < 0 ? last : std::min<std::size_t>(material, last)].at(at);
    return picture && !picture->isEmpty() ? picture : nullptr;
}

std::optional<Vec3f> ShadedSurface::baseColor(const SurfacePoint &point) const
{
    Vec2 at;
    if (const Picture *picture = pictureAt(0, point, at)) {
        std::array<float, 4> value{};
        sampleRepeated(*picture, at, std::span(value).first(std::size_t(picture->channels)));
        const bool isGrey = picture->channels < 3, isSrgb = textures.front().kind == TextureKind::Srgb;
        Vec3f color(value[0], value[isGrey ? 0 : 1], value[isGrey ? 0 : 2]);
        return isSrgb ? Vec3f(color.unaryExpr(&linearFromSrgb)) : color;
    }
    const auto &corners = mesh->triangles[point.triangle];
    if (cornerColors) {
        const auto color = [&](int k) -> const CornerColor & { return (*cornerColors)[corners[k]]; };
        if (color(0).known && color(1).known && color(2).known)
            return point.between<Vec3f>(color(0).value(), color(1).value(), color(2).value());
    }
    const int material = materialOf(point.triangle);
    if (material >= 0 && material < std::ssize(materialColors))
        return materialColors[material];
    return std::nullopt;
}

} // namespace autocuts
