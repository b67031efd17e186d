// Stacks of the islands of alike parts, as AlikeMode::Stack asks for.
#pragma once

#include "solver/unwrap/packjob.h"

namespace autocuts::unwrap {

//! Lays the charts that are copies of each other on the first one, mirrored copies as mirror images, and
//! makes one stack of each kind in PackJob::faceFlags, so that packing moves them together. Charts that stay,
//! are locked, grouped or stacked, or belong to a rectangle are left out. \param uv per corner, texture space
void stackAlike(const MeshData &mesh, const ChartMap &charts, PackJob &pack, UvMatrix &uv);

} // namespace autocuts::unwrap
