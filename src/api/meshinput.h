// Checks the mesh of a caller and takes it over. What is wrong is thrown as a Failure.
#pragma once

#include "model/plain/snapshot.h"

#include <autocuts/autocuts.h>

namespace autocuts::api {

//! The vertices, faces and objects.
std::shared_ptr<const MeshData> meshOf(const autocuts_mesh &mesh);

//! Per edge pair: normals of the caller differ there; empty when there are none.
std::vector<bool> hardEdgesOf(const autocuts_mesh &mesh, const MeshData &data);

//! Takes what belongs to the faces and corners of snapshot.mesh: the map, locks, edges, weights and pins.
//! \pre the mesh is the one of the snapshot, whose settings and height of a tile are set; texel weights give
//! the snapshot a mesh of its own
void takeWishes(const autocuts_mesh &mesh, Snapshot &snapshot);

} // namespace autocuts::api
