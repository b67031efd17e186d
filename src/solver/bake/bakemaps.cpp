#include "solver/bake/bakemaps.h"

#include "model/plain/sharpsampling.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace autocuts::bake {

namespace {

//! Rays begin this far from the surface, so that they do not meet their own triangle.
constexpr float lift = 2e-5F;

//! Colours that are far from each other: steps of the golden ratio through the hues.
Vec3f idColor(int index)
{
    const double hue = 6 * (0.1 + 0.618033988749895 * index - std::floor(0.1 + 0.618033988749895 * index));
    const auto part = [hue](double offset) {
        const double k = std::fmod(offset + hue, 6);
        return static_cast<float>(1 - 0.85 * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
    };
    return {part(5), part(3), part(1)};
}

void put(const Vec3f &value, std::span<float> out)
{
    std::copy_n(value.data(), 3, out.begin());
}

//! Samples the picture of a texture at a point. Returns false where there is none.
bool sampleTexture(const ShadedSurface &surface, int texture, const SurfacePoint &point,
                   std::span<float, 4> out)
{
    Vec2 at;
    const Picture *picture = surface.pictureAt(texture, point, at);
    if (!picture)
        return false;
    out[3] = 1;
    const std::vector<float> &stretch = surface.textures[texture].stretch;
    sampleSharply(*picture, at, stretch.empty() ? 1 : stretch[point.triangle],
                  out.first(std::size_t(picture->channels)));
    if (picture->channels == 1)
        out[1] = out[2] = out[0];
    return true;
}

} // namespace

std::span<const std::pair<std::string_view, MapKind>> mapNames()
{
    using enum MapKind;
    static constexpr std::array<std::pair<std::string_view, MapKind>, 10> names{{
        {"normal", Normal},
        {"object-normal", ObjectNormal},
        {"ao", Occlusion},
        {"bent-normal", BentNormal},
        {"curvature", Curvature},
        {"thickness", Thickness},
        {"position", Position},
        {"color", Color},
        {"material-id", MaterialId},
        {"height", Height},
    }};
    return names;
}

std::string_view nameOf(MapKind kind)
{
    const auto names = mapNames();
    const auto found =
        std::ranges::find_if(names, [kind](const auto &known) { return known.second == kind; });
    return found == names.end() ? std::string_view() : found->first;
}

int channelsOf(const ShadedSurface &source, const MapRequest &request)
{
    switch (request.kind) {
    case MapKind::Occlusion:
    case MapKind::Curvature:
    case MapKind::Thickness:
    case MapKind::Height:
        return 1;
    case MapKind::Texture: {
        int channels = 1;
        for (const TiledPicture &pictures : source.textures[request.texture].ofMaterial) {
            if (pictures.repeated)
                channels = std::max(channels, pictures.repeated->channels);
            for (const auto &[tile, picture] : pictures.tiles)
                channels = std::max(channels, picture->channels);
        }
        return channels;
    }
    default:
        return 3;
    }
}

Vec3f MapProbe::inTangentSpace(const SurfacePoint &at, const Vec3f &direction) const
{
    const Eigen::Matrix3f frame = mLow.tangentFrame(at);
    if (!(std::abs(frame.determinant()) > 1e-12F))
        return Vec3f::UnitZ();
    const Vec3f result = frame.inverse() * direction;
    return result.stableNormalized();
}

float MapProbe::occlusion(const Source &source, int rays, EvenPoints &points, Vec3f *open) const
{
    const ShadedSurface &surface = *source.surface;
    const Vec3f face = surface.faceNormal(source.point.triangle);
    const Vec3f normal = surface.shadingNormal(source.point);
    const Vec3f origin = mFrame.toFrame(surface.position(source.point)) + lift * face;
    const float reach = mSettings.reach > 0 ? static_cast<float>(mSettings.reach) : endless;
    int arrived = 0;
    for (int i = 0; i < rays; ++i) {
        const Vec3f direction = cosineDirection(normal, points.next());
        // Behind the face there is the model itself.
        if (direction.dot(face) <= 0 || source.rays->isBlocked(origin, direction, 0, reach))
            continue;
        ++arrived;
        if (open)
            *open += direction;
    }
    return static_cast<float>(arrived) / static_cast<float>(rays);
}

//! The share of a small ball around the point that the model fills: 1/2 - 3/16 * radius * mean curvature
//! (Pottmann et al. 2009, "Integral invariants for robust geometry processing").
float MapProbe::curvature(const Source &source, int rays, EvenPoints &points) const
{
    const ShadedSurface &surface = *source.surface;
    const Vec3f face = surface.faceNormal(source.point.triangle);
    const Vec3f position = mFrame.toFrame(surface.position(source.point));
    const auto radius = static_cast<float>(mSettings.curvatureRadius);
    float missing = 0; // of the ball's half, in balls
    for (int i = 0; i < rays; ++i) {
        const Vec3f direction = sphereDirection(points.next());
        const bool outwards = direction.dot(face) > 0;
        const Vec3f origin = position + (outwards ? lift : -lift) * face;
        const RayHit hit = source.rays->nearest(origin, direction, 0, radius);
        if (hit.point.triangle < 0)
            continue;
        const float share = hit.distance / radius;
        missing += (outwards ? -1.0F : 1.0F) * (1 - share * share * share);
    }
    return 16.0F / 3 * missing / static_cast<float>(rays);
}

float MapProbe::thickness(const Source &source, int rays, EvenPoints &points) const
{
    const ShadedSurface &surface = *source.surface;
    const Vec3f inwards = -surface.faceNormal(source.point.triangle);
    const Vec3f origin = mFrame.toFrame(surface.position(source.point)) + lift * inwards;
    const auto limit = static_cast<float>(mSettings.thicknessLimit);
    float sum = 0;
    for (int i = 0; i < rays; ++i) {
        const RayHit hit = source.rays->nearest(origin, cosineDirection(inwards, points.next()), 0, limit);
        sum += hit.point.triangle < 0 ? 1 : hit.distance / limit;
    }
    return sum / static_cast<float>(rays);
}

void MapProbe::texture(const MapRequest &request, const SurfacePoint &at, const Source &source,
                       std::span<float> out) const
{
    const ShadedSurface &surface = *source.surface;
    const TextureKind kind = surface.textures[request.texture].kind;
    const bool isNormal = kind == TextureKind::Normal || kind == TextureKind::NormalDirectX;
    std::array<float, 4> value{0, 0, 0, 1};
    const bool found = sampleTexture(surface, request.texture, source.point, value);
    if (isNormal) {
        // From one tangent space to the other.
        Vec3f normal = found ? Vec3f(2 * value[0] - 1, 2 * value[1] - 1, 2 * value[2] - 1) : Vec3f::UnitZ();
        const float up = kind == TextureKind::NormalDirectX ? -1.0F : 1.0F;
        normal.y() *= up;
        if (!surface.tangents.empty())
            normal = inTangentSpace(at, surface.tangentFrame(source.point) * normal);
        normal.y() *= up;
        put(0.5F * (normal + Vec3f::Ones()), value);
    } else if (kind == TextureKind::Srgb) {
        for (int k = 0; k < 3; ++k)
            value[k] = linearFromSrgb(value[k]);
    }
    std::copy_n(value.begin(), out.size(), out.begin());
}

void MapProbe::probe(const MapRequest &request, const SurfacePoint &at, const Source &source, int rays,
                     EvenPoints &points, std::span<float> out) const
{
    const ShadedSurface &surface = *source.surface;
    switch (request.kind) {
    case MapKind::Normal:
        put(inTangentSpace(at, surface.shadingNormal(source.point)), out);
        break;
    case MapKind::ObjectNormal:
        put(surface.shadingNormal(source.point), out);
        break;
    case MapKind::Occlusion:
        out[0] = occlusion(source, rays, points, nullptr);
        break;
    case MapKind::BentNormal: {
        Vec3f open = Vec3f::Zero();
        occlusion(source, rays, points, &open);
        if (open.squaredNorm() <= 0)
            open = surface.shadingNormal(source.point);
        put(inTangentSpace(at, open.normalized()), out);
        break;
    }
    case MapKind::Curvature:
        out[0] = curvature(source, rays, points);
        break;
    case MapKind::Thickness:
        out[0] = thickness(source, rays, points);
        break;
    case MapKind::Position:
        put(surface.position(source.point).cast<float>(), out);
        break;
    case MapKind::Color:
        put(surface.baseColor(source.point).value_or(Vec3f::Ones()), out);
        break;
    case MapKind::MaterialId:
        put(idColor(surface.materialOf(source.point.triangle) + 1), out);
        break;
    case MapKind::Height:
        out[0] = source.height * static_cast<float>(mFrame.size);
        break;
    case MapKind::Texture:
        texture(request, at, source, out);
        break;
    }
}

} // namespace autocuts::bake
