// Models with known maps at any resolution, for tests of what transfers maps.
#pragma once

#include "model/plain/meshdata.h"
#include "support/meshbuilders.h"

#include <functional>

namespace autocuts::test {

//! A mesh with one UV per corner.
struct MappedModel
{
    MeshPtr mesh;
    UvMatrix uv;
};

//! UV of a point of a face. \param centre of the face
using MapOf = std::function<Vec2(const Vec3 &point, const Vec3 &centre)>;

//! The mesh with the map of a function.
MappedModel mapped(const MeshPtr &mesh, const MapOf &map);

//! A box around the origin with n x n quads, or twice as many triangles, on each side.
MeshPtr box(int n, const Vec3 &size = Vec3(2, 2, 2), bool triangles = false);
//! Each side of a box around the origin is an island of its own, with lengths times 0.1.
MapOf boxMap(const Vec3 &size = Vec3(2, 2, 2));

//! The side of a cylinder of radius 1 and height 2 around z, its first edge at an angle.
MeshPtr tube(int segments, int rings, double angle = 0);
//! The tube unrolled: u from 0 to 2 pi with its seam at angle 0, v along z.
Vec2 tubeMap(const Vec3 &point, const Vec3 &centre);

//! A sphere as two islands, its halves above and below z = 0 seen from the poles, the lower one beside the
//! upper.
Vec2 halvesMap(const Vec3 &point, const Vec3 &centre);

} // namespace autocuts::test
