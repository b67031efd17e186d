// How sharply a mesh is bent along its edges. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! The unit normal of each polygon; zero for polygons without area.
std::vector<Vec3> faceNormals(const MeshData &mesh);

//! The angle between the normals of the two polygons at each edge pair, in radians: 0 where the surface is
//! flat, also along diagonals and at polygons without area.
std::vector<double> edgeAngles(const MeshData &mesh);

} // namespace autocuts
