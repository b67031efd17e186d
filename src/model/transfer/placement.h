// Finds out how a model lies to another one: programs disagree on units and on which axis is up. Plain: no
// Qt.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts::transfer {

//! A turn and scale about the origin.
struct Placement
{
    double scale = 1;
    int turn = 0; //!< quarter turns about x: 1 lets z up become y up, -1 the opposite

    bool isIdentity() const { return scale == 1 && turn == 0; }
};

//! The placements other than none that bring the box of `mesh` onto that of `target`, the best first: scales
//! between units of length, and turns between z up and y up.
std::vector<Placement> likelyPlacements(const MeshData &mesh, const MeshData &target);

//! True when the boxes of both agree so little that one can hardly be an edited version of the other in its
//! place.
bool liesElsewhere(const MeshData &mesh, const MeshData &target);

//! The mesh in its place.
std::shared_ptr<const MeshData> placed(const MeshData &mesh, const Placement &placement);

//! A direction of the mesh in its place, as long as before.
Vec3 turnedOnly(const Vec3 &direction, const Placement &placement);

} // namespace autocuts::transfer
