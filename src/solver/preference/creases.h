// Sharp edges: where they are and whether a mesh is made of them.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts::preference {

//! Per edge pair: angle between the normals of the two polygons, radians in [0, pi]; 0 on diagonals, so that
//! a bent polygon has no edge inside.
std::vector<double> dihedralAngles(const MeshData &mesh);

//! Per edge pair: true for sharp edges (40 degrees or more) amid smooth surroundings: of the other edges at
//! their ends at most a fifth by length has an angle from 15 to 40 degrees. A rough organic surface has sharp
//! edges but hardly any of these.
std::vector<bool> creases(const MeshData &mesh, const std::vector<double> &angles);

//! True when at least 1 % of the length of all edges is a crease, and at least 70 % of the length of the
//! sharp ones.
bool isHardSurface(const MeshData &mesh);

//! Factor per edge pair: 1 on smooth edges, 1 - strength on those of 60 degrees or more, between from 20
//! degrees on. \param strength in [0, 1]
std::vector<double> creaseFactors(const MeshData &mesh, double strength);

} // namespace autocuts::preference
