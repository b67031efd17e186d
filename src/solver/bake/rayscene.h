// Finds where rays meet the triangles of a model, with Embree.
#pragma once

#include "model/plain/shadedsurface.h"
#include "solver/base/jobcontext.h"

#include <limits>
#include <memory>
#include <span>

namespace autocuts::bake {

//! Directions, and points in the frame of a bake: the mesh is moved to the origin and scaled to a size of 1,
//! so that single precision is enough.
using Vec3f = Eigen::Vector3f;

//! The coordinates of a bake: the model moved and scaled to a common size.
struct Frame
{
    Vec3 origin = Vec3::Zero();
    double size = 1; //!< diagonal of the bounding box

    //! Around the bounding box of the vertices that have faces.
    static Frame of(const MeshData &mesh);
    Vec3f toFrame(const Vec3 &point) const { return ((point - origin) / size).cast<float>(); }
    Vec3 fromFrame(const Vec3f &point) const { return point.cast<double>() * size + origin; }
};

//! Where a ray meets the surface first.
struct RayHit
{
    SurfacePoint point;
    float distance = 0;      //!< in lengths of the direction
    bool fromBehind = false; //!< the ray meets the back of the triangle
};

inline constexpr float endless = std::numeric_limits<float>::infinity();

//! Triangles prepared for rays; immutable. Triangles without area are never met.
class RayScene final
{
public:
    //! \param triangles of the mesh; empty: all \param job when it is stopped before the end, no ray meets
    //! anything
    RayScene(const MeshData &mesh, const Frame &frame, std::span<const int> triangles = {},
             const JobContext &job = {});
    ~RayScene();
    RayScene(RayScene &&) noexcept;
    RayScene &operator=(RayScene &&) noexcept;

    //! The first triangle between two distances; point.triangle is -1 when there is none.
    RayHit nearest(const Vec3f &origin, const Vec3f &direction, float from, float to) const;
    //! The same, but only triangles that face the origin count.
    RayHit nearestFacing(const Vec3f &origin, const Vec3f &direction, float from, float to) const;
    //! True when there is any triangle between two distances.
    bool isBlocked(const Vec3f &origin, const Vec3f &direction, float from, float to) const;

private:
    struct Embree;
    std::unique_ptr<Embree> mEmbree;
    std::vector<int> mTriangles; //!< their numbers in the mesh; empty: all
};

} // namespace autocuts::bake
