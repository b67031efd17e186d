// Finds the regions of a surface that keep their shape in the map.
#pragma once

#include "model/plain/snapshot.h"

namespace autocuts::rigid {

//! The rigid regions of a mesh, without RigidRegions::stiffness and apart.
//!
//! A flat region is a set of connected triangles in one plane. It is large enough to be seen, and at least
//! half of its border is sharp or open. Softer borders do when it is large beside its neighbours. Single
//! polygons with a sharp border count only in components that are made of rigid regions.
//!
//! A developable region is a set of connected triangles without sharp edges between them, whose inner
//! vertices have no angle defect, or that meet in the single tip of a cone.
//!
//! A connected component that has more curved surface than such regions keeps only its caps.
//! \param creases per edge pair: sharp edges of which borders are made, see preference/creases
//! A region has one texel weight. Triangles without area in 3D belong to the region around them.
[[nodiscard]] RigidRegions findRigidRegions(const MeshData &mesh, const std::vector<bool> &creases);

//! Share of the area that is in rigid regions, in [0, 1].
[[nodiscard]] double rigidShare(const MeshData &mesh, const RigidRegions &regions);

} // namespace autocuts::rigid
