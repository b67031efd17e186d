// Normals for shading: one per polygon corner, smoothed across the edges that are not hard. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! The unit normal of each polygon corner. Corners at one vertex that are connected over smooth edges share
//! the sum of their polygons' normals, weighted by the angles at the corners. Hard are the given edges,
//! borders, edges with more than two faces, and edges between faces of opposite winding. Where no hard edges
//! are given, those are hard whose faces meet at more than 40 degrees, and all edges of faces without area.
//! These are the split normals of Blender 3.4. Corners at which the sum vanishes get that of their whole
//! vertex, or else the normal of their polygon, or else (0, 0, 1).
//! \param hardEdges per edge pair, as in Scene::hardEdges; empty when nothing is known
std::vector<Eigen::Vector3f> shadingNormals(const MeshData &mesh, const std::vector<bool> &hardEdges);

} // namespace autocuts
