#include "solver/bake/pathtracer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::bake {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
//! How far above the surface rays start, as a share of the model's size: more than rounding of positions.
constexpr float lift = 4e-6F;
//! Shadow rays end this share of their length before the light.
constexpr float shortening = 1e-4F;
//! From this bounce on, dark paths may end early.
constexpr int certainBounces = 2;

float luminance(const Vec3f &color)
{
    return color.dot(Vec3f(0.2126F, 0.7152F, 0.0722F));
}

//! The weight of an estimate by one of two ways to sample (Veach 1995, power heuristic).
float weightOf(float own, float other)
{
    return own * own / std::max(own * own + other * other, 1e-30F);
}

} // namespace

PathTracer::PathTracer(const LitSurface &surface, const Lighting &lighting, int bounces,
                       const JobContext &job)
    : mSurface(surface), mSuns(lighting.suns), mSky(lighting.sky), mBounces(bounces),
      mFrame(Frame::of(*surface.mesh)), mRays(*surface.mesh, mFrame, {}, job)
{
    addEmitters(lighting);
}

void PathTracer::addEmitters(const Lighting &lighting)
{
    const auto add = [this](Emitter emitter) {
        const Vec3f normal = emitter.first.cross(emitter.second);
        emitter.area = (emitter.isTriangle ? 0.5F : 1.0F) * normal.norm();
        emitter.normal = normal.stableNormalized();
        emitter.chance = emitter.area * luminance(emitter.radiance);
        if (!(emitter.chance > 0))
            return false;
        mEmitters.push_back(emitter);
        return true;
    };
    for (const AreaLight &light : lighting.areas) {
        const Vec3f right = (2 * light.right / mFrame.size).cast<float>();
        const Vec3f up = (2 * light.up / mFrame.size).cast<float>();
        const Vec3f corner = mFrame.toFrame(light.centre - light.right - light.up);
        add({corner, right, up, light.radiance, {}, 0, false, 0});
    }
    mAreaLights = static_cast<int>(mEmitters.size());
    const MeshData &mesh = *mSurface.mesh;
    if (!mSurface.emission.empty())
        mEmitterOfTriangle.assign(mesh.triangleCount(), -1);
    for (int t = 0; t < mesh.triangleCount() && !mSurface.emission.empty(); ++t) {
        const Vec3f corner = positionAt({t, 0, 0});
        if (add({corner,
                 positionAt({t, 1, 0}) - corner,
                 positionAt({t, 0, 1}) - corner,
                 mSurface.emission[mesh.triangleFace[t]],
                 {},
                 0,
                 true,
                 0}))
            mEmitterOfTriangle[t] = static_cast<int>(mEmitters.size()) - 1;
    }
    double sum = 0, done = 0;
    for (const Emitter &emitter : mEmitters)
        sum += double(emitter.chance);
    for (Emitter &emitter : mEmitters) {
        done += double(emitter.chance);
        emitter.chance = static_cast<float>(double(emitter.chance) / sum);
        mChances.push_back(static_cast<float>(done / sum));
    }
}

Vec3f PathTracer::positionAt(const SurfacePoint &at) const
{
    const auto &corners = mSurface.mesh->triangles[at.triangle];
    const auto corner = [&](int k) { return mSurface.mesh->cornerPosition(corners[k]); };
    return mFrame.toFrame(at.between<Vec3>(corner(0), corner(1), corner(2)));
}

Vec3f PathTracer::normalAt(const SurfacePoint &at) const
{
    const auto &corners = mSurface.mesh->triangles[at.triangle];
    const auto &normals = mSurface.normals;
    const Vec3f normal =
        at.between<Vec3f>(normals[corners[0]], normals[corners[1]], normals[corners[2]]).stableNormalized();
    return normal.allFinite() ? normal : Vec3f(Vec3f::Zero());
}

//! \param from the direction of the ray that met this place; null: the side of the shading normal
PathTracer::Place PathTracer::placeAt(const SurfacePoint &at, const Vec3f *from) const
{
    const auto &corners = mSurface.mesh->triangles[at.triangle];
    const Vec3 a = mSurface.mesh->cornerPosition(corners[0]);
    Vec3f outside = (mSurface.mesh->cornerPosition(corners[1]) - a)
                        .cross(mSurface.mesh->cornerPosition(corners[2]) - a)
                        .stableNormalized()
                        .cast<float>();
    Vec3f normal = normalAt(at);
    if (from) {
        if (outside.dot(*from) > 0)
            outside = -outside;
        if (normal.dot(outside) < 0)
            normal = -normal;
    } else if (outside.dot(normal) < 0) {
        outside = -outside;
    }
    if (normal.isZero(0))
        normal = outside;
    return {positionAt(at) + lift * outside, normal, outside};
}

Vec3f PathTracer::fromSuns(const Place &place, const Draw &draw) const
{
    Vec3f sum = Vec3f::Zero();
    for (std::size_t i = 0; i < mSuns.size(); ++i) {
        const Sun &sun = mSuns[i];
        const Eigen::Vector2f point = draw(Draw::OnSun, static_cast<std::uint32_t>(i));
        const float low = std::cos(sun.angle / 2);
        const float cosine = 1 - point.x() * (1 - low), angle = 2 * pi * point.y();
        const float sine = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
        Vec3f first, second;
        makeBasis(sun.towards, first, second);
        const Vec3f direction =
            cosine * sun.towards + sine * (std::cos(angle) * first + std::sin(angle) * second);
        const float arriving = direction.dot(place.normal);
        if (arriving > 0 && direction.dot(place.outside) > 0 &&
            !mRays.isBlocked(place.origin, direction, 0, endless))
            sum += arriving / pi * sun.irradiance;
    }
    return sum;
}

//! The chance, per solid angle, that a point of the emitter is chosen; zero on its dark side.
float PathTracer::sharePerAngle(const Emitter &emitter, const Vec3f &direction, float distance)
{
    const float cosine = -emitter.normal.dot(direction);
    const float facing = emitter.isTriangle ? std::abs(cosine) : cosine;
    return facing > 0 ? emitter.chance * distance * distance / (emitter.area * facing) : 0;
}

//! Light from a point that is chosen on an emitter.
Vec3f PathTracer::fromEmitter(const Place &place, const Draw &draw) const
{
    if (mEmitters.empty())
        return Vec3f::Zero();
    const float choice = draw(Draw::Choice).x();
    const auto found = std::upper_bound(mChances.begin(), mChances.end() - 1, choice);
    const Emitter &emitter = mEmitters[found - mChances.begin()];
    Eigen::Vector2f at = draw(Draw::OnEmitter);
    if (emitter.isTriangle) {
        const float root = std::sqrt(at.x());
        at = {root * (1 - at.y()), root * at.y()};
    }
    const Vec3f way = emitter.corner + at.x() * emitter.first + at.y() * emitter.second - place.origin;
    const float distance = way.norm();
    const Vec3f direction = way.stableNormalized();
    const float arriving = direction.dot(place.normal), share = sharePerAngle(emitter, direction, distance);
    if (!(arriving > 0 && direction.dot(place.outside) > 0 && share > 0) ||
        mRays.isBlocked(place.origin, way, 0, 1 - shortening))
        return Vec3f::Zero();
    const float density = arriving / pi; // of the other way to sample
    return density / share * weightOf(share, density) * emitter.radiance;
}

//! The light of an emitter that a ray meets, weighted beside fromEmitter().
Vec3f PathTracer::seen(const Emitter &emitter, const Place &place, const Vec3f &direction,
                       float distance) const
{
    const float share = sharePerAngle(emitter, direction, distance);
    const bool isSeen = emitter.isTriangle || share > 0;
    return isSeen ? Vec3f(weightOf(direction.dot(place.normal) / pi, share) * emitter.radiance)
                  : Vec3f(Vec3f::Zero());
}

//! The light of all that shines along a ray up to where it meets the surface.
Vec3f PathTracer::along(const Place &place, const Vec3f &direction, const RayHit &hit) const
{
    const bool meets = hit.point.triangle >= 0;
    Vec3f sum = Vec3f::Zero();
    for (int i = 0; i < mAreaLights; ++i) {
        const Emitter &light = mEmitters[i];
        const float sinking = light.normal.dot(direction);
        const float distance = light.normal.dot(light.corner - place.origin) / sinking;
        if (!(sinking < 0 && distance > 0) || (meets && distance > hit.distance))
            continue;
        // Coordinates along the sides, which need not be at right angles.
        const Vec3f inside = place.origin + distance * direction - light.corner;
        const float u = inside.cross(light.second).dot(light.normal) / light.area;
        const float v = light.first.cross(inside).dot(light.normal) / light.area;
        if (u >= 0 && u <= 1 && v >= 0 && v <= 1)
            sum += seen(light, place, direction, distance);
    }
    if (!meets)
        return mSky ? Vec3f(sum + mSky->radiance(direction)) : sum;
    const int emitter = mEmitterOfTriangle.empty() ? -1 : mEmitterOfTriangle[hit.point.triangle];
    return emitter < 0 ? sum : Vec3f(sum + seen(mEmitters[emitter], place, direction, hit.distance));
}

ArrivingLight PathTracer::trace(const SurfacePoint &at, const ScrambledPoints &points,
                                std::uint32_t sample) const
{
    ArrivingLight light;
    Place place = placeAt(at, nullptr);
    Vec3f reflected = Vec3f::Ones();
    for (int bounce = 0;; ++bounce) {
        const Draw draw{points, sample, static_cast<std::uint32_t>(bounce)};
        Vec3f arriving = fromSuns(place, draw) + fromEmitter(place, draw);
        const Vec3f direction = cosineDirection(place.normal, draw(Draw::Direction));
        RayHit hit;
        if (direction.dot(place.outside) > 0) {
            hit = mRays.nearest(place.origin, direction, 0, endless);
            arriving += along(place, direction, hit);
        }
        (bounce == 0 ? light.direct : light.indirect) += reflected.cwiseProduct(arriving);
        if (hit.point.triangle < 0 || bounce >= mBounces)
            return light;
        reflected = reflected.cwiseProduct(mSurface.albedo(hit.point).cwiseMax(0.0F).cwiseMin(1.0F));
        const float chance = bounce < certainBounces ? 1 : std::min(1.0F, reflected.maxCoeff());
        if (!(reflected.maxCoeff() > 0) || draw(Draw::Choice).y() >= chance)
            return light;
        reflected /= chance;
        place = placeAt(hit.point, &direction);
    }
}

} // namespace autocuts::bake
