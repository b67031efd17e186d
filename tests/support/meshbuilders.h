// Small meshes built in code, for tests.
#pragma once

#include "model/plain/meshdata.h"

#include <QString>

#include <memory>
#include <string>
#include <vector>

namespace autocuts::test {

using MeshPtr = std::shared_ptr<const MeshData>;

//! A mesh from points and polygons, all in one object.
MeshPtr polygonMesh(const std::vector<Vec3> &points, const std::vector<std::vector<int>> &faces);
//! One triangle in the plane.
MeshPtr triangle();
//! Unit cube of 12 triangles.
MeshPtr cube();
//! Unit cube of 6 quads.
MeshPtr quadCube();
//! n x n quads over the unit square, bulged by `height` in z.
MeshPtr grid(int n, double height = 0);
//! Closed sphere of triangles, `rings` x `segments`.
MeshPtr sphere(int rings, int segments);
//! The same with the faces of its lower half turned over: no map can close the equator.
MeshPtr turnedSphere(int rings, int segments);
//! Torus of quads.
MeshPtr torus(int major, int minor);

//! Triangles and quads with everything wrong at once, far from the origin: a non-manifold edge of four faces,
//! a duplicated and a flipped face, two degenerate triangles, an isolated vertex and a double of a vertex.
MeshPtr dirty();

//! One of these by its name, for rows of tests: "triangle", "cube", "quad cube", "grid" (bulged), "sphere",
//! "turned sphere", "torus" or "dirty"; of any other name, the sample that makeSample() has.
MeshPtr meshNamed(const QString &name);

//! Where the real meshes are: $AUTOCUTS_MESHES or ../shared/meshes beside the checkout; empty when absent.
std::string meshFolder();
//! What a test says that is skipped because a real mesh is absent: scripts/test counts these.
inline constexpr const char *noMeshes = "no meshes: set AUTOCUTS_MESHES";

} // namespace autocuts::test
