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
//! A curved region is a smooth set of connected triangles with one border, sharp nearly all around, that is
//! bent too little to stretch much in the plane: a panel of a car, the side of a cushion.
//!
//! A connected component that has more curved surface than such regions keeps only its caps.
//! A region has one texel weight. Triangles without area in 3D belong to the region around them.
//! \param creases per edge pair: sharp edges of which borders are made, see preference/creases
//! \param bent per triangle: true in regions that were found to be bent too much; empty: none
[[nodiscard]] RigidRegions findRigidRegions(const MeshData &mesh, const std::vector<bool> &creases,
                                            const std::vector<bool> &bent = {});

//! Share of the area that is in rigid regions, in [0, 1].
[[nodiscard]] double rigidShare(const MeshData &mesh, const RigidRegions &regions);

} // namespace autocuts::rigid
