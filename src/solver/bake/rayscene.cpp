#include "solver/bake/rayscene.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>

#include <new>
#include <stdexcept>

namespace autocuts::bake {

struct RayScene::Embree
{
    RTCScene scene = nullptr;
    bool isReady = false; //!< otherwise the scene was not finished

    ~Embree()
    {
        if (scene)
            rtcReleaseScene(scene);
    }
};

namespace {

RTCRay rayOf(const Vec3f &origin, const Vec3f &direction, float from, float to)
{
    RTCRay ray{};
    ray.org_x = origin.x();
    ray.org_y = origin.y();
    ray.org_z = origin.z();
    ray.dir_x = direction.x();
    ray.dir_y = direction.y();
    ray.dir_z = direction.z();
    ray.tnear = from;
    ray.tfar = to;
    ray.mask = ~0U;
    return ray;
}

//! Skips triangles whose back is met.
void keepFacing(const RTCFilterFunctionNArguments *arguments)
{
    const auto *ray = reinterpret_cast<const RTCRay *>(arguments->ray);
    const auto *hit = reinterpret_cast<const RTCHit *>(arguments->hit);
    const float along = ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z;
    if (along >= 0)
        arguments->valid[0] = 0;
}

//! One for all scenes: a process can have about a thousand. With one thread: trees are the same on any
//! machine.
RTCDevice device()
{
    static const RTCDevice only = rtcNewDevice("threads=1");
    if (!only)
        throw std::runtime_error("Embree cannot be used on this processor");
    return only;
}

//! Ends the making of a tree with the job.
bool goesOn(void *job, double)
{
    return !static_cast<const JobContext *>(job)->stopped();
}

RayHit traced(RTCScene scene, RTCIntersectContext &context, RTCRayHit &ray, const std::vector<int> &triangles)
{
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &ray);
    RayHit result;
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return result;
    const int number = static_cast<int>(ray.hit.primID);
    result.point = {triangles.empty() ? number : triangles[number], ray.hit.u, ray.hit.v};
    result.distance = ray.ray.tfar;
    result.fromBehind =
        ray.ray.dir_x * ray.hit.Ng_x + ray.ray.dir_y * ray.hit.Ng_y + ray.ray.dir_z * ray.hit.Ng_z >= 0;
    return result;
}

} // namespace

Frame Frame::of(const MeshData &mesh)
{
    Eigen::AlignedBox3d box;
    for (const int vertex : mesh.cornerVertex)
        box.extend(Vec3(mesh.positions.row(vertex)));
    Frame frame;
    if (!box.isEmpty())
        frame.origin = box.center();
    if (!box.isEmpty() && box.diagonal().norm() > 0)
        frame.size = box.diagonal().norm();
    return frame;
}

RayScene::RayScene(const MeshData &mesh, const Frame &frame, std::span<const int> triangles,
                   const JobContext &job)
    : mEmbree(std::make_unique<Embree>()), mTriangles(triangles.begin(), triangles.end())
{
    mEmbree->scene = rtcNewScene(device());
    rtcSetSceneFlags(mEmbree->scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    const std::size_t count = mTriangles.empty() ? mesh.triangles.size() : mTriangles.size();
    RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto *positions =
        static_cast<float *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                     3 * sizeof(float), std::size_t(mesh.vertexCount())));
    auto *corners = static_cast<unsigned *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
    if ((!positions && mesh.vertexCount() > 0) || (!corners && count > 0)) {
        rtcReleaseGeometry(geometry);
        throw std::bad_alloc();
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3f point = frame.toFrame(mesh.positions.row(v));
        std::copy_n(point.data(), 3, positions + 3 * std::ptrdiff_t(v));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const int triangle = mTriangles.empty() ? static_cast<int>(i) : mTriangles[i];
        for (int k = 0; k < 3; ++k)
            corners[3 * i + k] = static_cast<unsigned>(mesh.cornerVertex[mesh.triangles[triangle][k]]);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(mEmbree->scene, geometry);
    rtcReleaseGeometry(geometry);
    JobContext watched = job.quiet();
    rtcSetSceneProgressMonitorFunction(mEmbree->scene, goesOn, &watched);
    rtcCommitScene(mEmbree->scene);
    rtcSetSceneProgressMonitorFunction(mEmbree->scene, nullptr, nullptr);
    mEmbree->isReady = !watched.stopped();
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene &&) noexcept = default;
RayScene &RayScene::operator=(RayScene &&) noexcept = default;

RayHit RayScene::nearest(const Vec3f &origin, const Vec3f &direction, float from, float to) const
{
    if (!mEmbree->isReady)
        return {};
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{rayOf(origin, direction, from, to), {}};
    return traced(mEmbree->scene, context, ray, mTriangles);
}

RayHit RayScene::nearestFacing(const Vec3f &origin, const Vec3f &direction, float from, float to) const
{
    if (!mEmbree->isReady)
        return {};
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.filter = keepFacing;
    RTCRayHit ray{rayOf(origin, direction, from, to), {}};
    return traced(mEmbree->scene, context, ray, mTriangles);
}

bool RayScene::isBlocked(const Vec3f &origin, const Vec3f &direction, float from, float to) const
{
    if (!mEmbree->isReady)
        return false;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = rayOf(origin, direction, from, to);
    rtcOccluded1(mEmbree->scene, &context, &ray);
    return ray.tfar < 0;
}

} // namespace autocuts::bake
