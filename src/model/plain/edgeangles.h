// How sharply a mesh is bent along its edges. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! The unit normal of each polygon; zero for polygons without area.
std::vector<Vec3> faceNormals(const MeshData &mesh);

//! The angle between the normals of the two polygons at each edge pair, radians in [0, pi]: 0 where the
//! surface is flat and at polygons without area; 0 along diagonals, so that a polygon that is not planar has
//! no sharp edge inside.
std::vector<double> edgeAngles(const MeshData &mesh);

} // namespace autocuts
