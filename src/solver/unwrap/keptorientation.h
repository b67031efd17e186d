// Keeps how islands are turned when they get a new map.
#pragma once

#include "solver/unwrap/packjob.h"

namespace autocuts::unwrap {

//! Turns the charts that keep their orientation (IslandFlags::upright, aligned) as they were in the map
//! before, as far as a rotation can. Charts that packing leaves where they are stay. \param before the map
//! before, \param uv the new one: per corner, texture space
void keepOrientations(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                      const UvMatrix &before, UvMatrix &uv);

} // namespace autocuts::unwrap
