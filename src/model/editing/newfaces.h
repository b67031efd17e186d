// Finds room for new faces beside a map.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! Lays faces that have no UVs, or that lie on others or are much distorted, beside the map: neighbours of
//! nearly one direction together, flat, at the texel density of the other faces. \param uv one row per corner
//! \param among which faces may be moved \returns how many were
int layBeside(const MeshData &mesh, UvMatrix &uv, const std::vector<bool> &among);

} // namespace autocuts
