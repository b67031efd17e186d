// Sharp edges and creases.
#pragma once

#include "model/plain/meshdata.h"

#include <numbers>
#include <vector>

namespace autocuts::preference {

//! Angle between the normals of two polygons from which their edge is sharp, radians. Chosen by hand.
inline constexpr double sharpAngle = 40 * std::numbers::pi / 180;

//! Per edge pair: true for creases. A crease is a sharp edge (40 degrees or more) in smooth surroundings: of
//! the other edges at its ends, at most a fifth by length has an angle from 15 to 40 degrees. A rough organic
//! surface has sharp edges but hardly any creases.
//! \param angles see edgeAngles()
std::vector<bool> creases(const MeshData &mesh, const std::vector<double> &angles);

//! True for a surface of many triangles that bends by more than a smooth one at half of its edges (by
//! length): a scan or the output of a generator, with noise. Sides at edges of several faces count as bent.
//! \param angles see edgeAngles()
bool isRough(const MeshData &mesh, const std::vector<double> &angles);

//! Cost factor per edge pair: 1 up to 20 degrees, 1 - strength from 60 degrees on, linear in between; at
//! least 0.001.
//! \param strength in [0, 1]
std::vector<double> creaseFactors(const MeshData &mesh, double strength);

} // namespace autocuts::preference
