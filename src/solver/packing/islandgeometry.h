// Between a mesh with UVs and the packer: charts to islands and placements back to UVs.
#pragma once

#include "model/plain/chart.h"
#include "solver/packing/packing.h"

namespace autocuts::packing {

//! One island per chart, with the chart's open edges.
//! \param uv one row per corner, UV units
//! \param locked per chart; empty: none is locked
std::vector<PackIsland> makePackIslands(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts,
                                        const std::vector<bool> &locked = {});

//! Moves every chart that is not locked to its placement. Equal UVs of a chart stay equal. Does nothing when
//! the result is not complete. \pre the result is that of makePackIslands() with the same charts and locks
void applyPlacements(const PackResult &result, const MeshData &mesh, const ChartMap &charts, UvMatrix &uv,
                     const std::vector<bool> &locked = {});

//! Scales every chart about the middle of its box so that UV area / 3D area is the same for all of them,
//! and the UV area of all together is what it was. Charts without area in the mesh or the map are left alone,
//! as are the locked ones, which then also set the density for the others.
void equalizeTexelDensity(const MeshData &mesh, const ChartMap &charts, UvMatrix &uv,
                          const std::vector<bool> &locked = {});

} // namespace autocuts::packing
