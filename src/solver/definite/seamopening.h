// Opens seams inside islands by moving their corners, where whole charts cannot move.
#pragma once

#include "model/plain/snapshot.h"

namespace autocuts::definite {

//! Opens seams whose two sides have the same UVs: each UV vertex on them moves into its own side by half the
//! width of a gap (seamGap()), or by less where triangles are small. So no triangle is flipped, each keeps
//! most of its height, and nothing is covered that was free. The ends of a slit are one UV vertex and stay.
//! \param apart per corner, true when the polygon side that starts there is such a seam
//! \param held per face, true when its corners stay; empty: none
//! \param uv one row per corner
void openSides(const MeshData &mesh, const std::vector<bool> &apart, const std::vector<bool> &held,
               UvMatrix &uv);

//! openSides() on the edges that the user cut, which solving on a flat place brings together again. Faces
//! with hard pins stay. \param uv one row per corner, any unit
void openCuts(const Snapshot &snapshot, UvMatrix &uv);

//! The corners at which the two sides of each edge pair start, marked per corner.
//! \param edges edge pairs, no diagonals
std::vector<bool> sidesOf(const MeshData &mesh, const std::vector<int> &edges);

} // namespace autocuts::definite
