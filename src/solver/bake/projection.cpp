#include "solver/bake/projection.h"

#include "solver/bake/bentedges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace autocuts::bake {

namespace {

//! Corrected rays turn over this many cage distances.
constexpr float turningDistances = 2;

float distanceTo(const std::array<Vec3f, 2> &edge, const Vec3f &point)
{
    const Vec3f along = edge[1] - edge[0];
    const float length = along.squaredNorm();
    const float t = length > 0 ? std::clamp((point - edge[0]).dot(along) / length, 0.0F, 1.0F) : 0;
    return (edge[0] + t * along - point).norm();
}

//! Per welded vertex: the normals of its triangles, weighted by their angles there, over all edges.
std::vector<Vec3f> smoothNormals(const MeshData &mesh)
{
    std::vector<Vec3> sums(mesh.vertexCount(), Vec3::Zero());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        std::array<Vec3, 3> at;
        for (int k = 0; k < 3; ++k)
            at[k] = mesh.cornerPosition(mesh.triangles[t][k]);
        const Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]).stableNormalized();
        for (int k = 0; k < 3 && normal.allFinite(); ++k) {
            const Vec3 a = (at[(k + 1) % 3] - at[k]).stableNormalized();
            const Vec3 b = (at[(k + 2) % 3] - at[k]).stableNormalized();
            const double angle = std::acos(std::clamp(a.dot(b), -1.0, 1.0));
            if (std::isfinite(angle))
                sums[mesh.vertexOfSoup(3 * t + k)] += angle * normal;
        }
    }
    std::vector<Vec3f> normals;
    for (const Vec3 &sum : sums)
        normals.push_back(sum.stableNormalized().cast<float>());
    return normals;
}

} // namespace

Projection::Projection(const ShadedSurface &low, const ShadedSurface &same, const Frame &frame,
                       const JobContext &job, bool withRays)
    : mLow(low), mHigh(same), mFrame(frame)
{
    if (withRays)
        prepareRays(same, job);
}

Projection::Projection(const ShadedSurface &low, const ShadedSurface &high, const Frame &frame,
                       const CageSettings &cage, const JobContext &job)
    : mLow(low), mHigh(high), mFrame(frame), mSame(false), mDistance(static_cast<float>(cage.distance)),
      mDirection(cage.direction)
{
    prepareRays(high, job);
    prepareDirections(cage);
}

void Projection::prepareRays(const ShadedSurface &surface, const JobContext &job)
{
    if (surface.faceGroup.empty()) {
        mRays.emplace_back(*surface.mesh, mFrame, std::span<const int>(), job);
        return;
    }
    std::vector<std::vector<int>> groups(
        std::size_t(1) + *std::max_element(surface.faceGroup.begin(), surface.faceGroup.end()));
    for (int t = 0; t < surface.mesh->triangleCount(); ++t)
        groups[surface.groupOf(t)].push_back(t);
    for (const std::vector<int> &triangles : groups) {
        // An empty list would stand for all triangles.
        mRays.push_back(triangles.empty() ? RayScene(MeshData(), mFrame)
                                          : RayScene(*surface.mesh, mFrame, triangles, job));
    }
}

void Projection::prepareDirections(const CageSettings &cage)
{
    const MeshData &mesh = *mLow.mesh;
    for (Eigen::Index v = 0; v < cage.positions.rows(); ++v)
        mCage.push_back(mFrame.toFrame(cage.positions.row(v)));
    if (!mCage.empty())
        return;
    mSmoothed = smoothNormals(mesh);
    if (mDirection == CageDirection::Corrected)
        mBends = bentEdgesNear(mesh, mFrame, turningDistances * mDistance);
}

Vec3f Projection::direction(const SurfacePoint &low) const
{
    if (mDirection == CageDirection::Shading)
        return mLow.shadingNormal(low);
    const MeshData &mesh = *mLow.mesh;
    const auto at = [&](int k) { return mSmoothed[mesh.vertexOfSoup(3 * low.triangle + k)]; };
    Vec3f smoothed = low.between<Vec3f>(at(0), at(1), at(2)).stableNormalized();
    if (mDirection == CageDirection::Corrected) {
        float nearest = turningDistances * mDistance;
        const Vec3f position = mFrame.toFrame(mLow.position(low));
        for (const auto &edge : mBends[low.triangle])
            nearest = std::min(nearest, distanceTo(edge, position));
        const float t = mDistance > 0 ? nearest / (turningDistances * mDistance) : 1;
        const float share = t * t * (3 - 2 * t);
        smoothed = ((1 - share) * smoothed + share * mLow.faceNormal(low.triangle)).stableNormalized();
    }
    return smoothed.squaredNorm() > 0.5F ? smoothed : mLow.faceNormal(low.triangle);
}

Source Projection::find(const SurfacePoint &low) const
{
    const std::size_t group = static_cast<std::size_t>(mLow.groupOf(low.triangle));
    if (mSame)
        return {&mHigh, mRays.empty() ? nullptr : &mRays[group], low, 0};
    if (group >= mRays.size())
        return {};
    const Vec3f position = mFrame.toFrame(mLow.position(low));
    Vec3f inwards;
    if (mCage.empty()) {
        inwards = -mDistance * direction(low);
    } else {
        const auto &corners = mLow.mesh->triangles[low.triangle];
        const auto at = [&](int k) { return mCage[mLow.mesh->cornerVertex[corners[k]]]; };
        inwards = position - low.between<Vec3f>(at(0), at(1), at(2));
    }
    const RayScene &rays = mRays[group];
    const RayHit hit = rays.nearestFacing(position - inwards, inwards, 0, 2);
    if (hit.point.triangle < 0)
        return {};
    return {&mHigh, &rays, hit.point, (1 - hit.distance) * inwards.norm()};
}

} // namespace autocuts::bake
