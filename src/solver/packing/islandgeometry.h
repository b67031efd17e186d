// Conversion between a mesh with UVs and the packer: charts to islands, and placements back to UVs.
#pragma once

#include "model/plain/chart.h"
#include "solver/packing/packing.h"

namespace autocuts::packing {

//! Makes one island per chart, with the chart's triangles and boundary.
//! \param uv one row per corner, UV units
//! \param locked per chart; empty: none is locked
std::vector<PackIsland> makePackIslands(const MeshData &mesh, const UvMatrix &uv, const ChartMap &charts,
                                        const std::vector<bool> &locked = {});

//! Moves the UVs of every chart that is not locked to its placement. Equal UVs of a chart stay equal. Does
//! nothing when the result is not complete.
//! \pre the result belongs to the islands that makePackIslands() made of the same charts and locks
void applyPlacements(const PackResult &result, const MeshData &mesh, const ChartMap &charts, UvMatrix &uv,
                     const std::vector<bool> &locked = {});

//! What the density of a chart is read from.
enum class DensityBasis {
    Area,      //!< the whole chart: UV area / 3D area
    FlatParts, //!< what keeps its shape at one scale, where that is a good part of the chart; else the whole
               //!< chart
    Given      //!< nothing: charts keep the densities that they have in relation to each other
};

//! Gives all charts one texel density: scales each about the middle of its box so that UV area / 3D area is
//! equal where the texel weights of the mesh are 1, and as these want it elsewhere, with the total UV area
//! unchanged (by DensityBasis::FlatParts nearly so). Locked charts keep their size and, if there are any, set
//! the density of the others. Charts without area in 3D or UV are left alone.
void equalizeTexelDensity(const MeshData &mesh, const ChartMap &charts, UvMatrix &uv,
                          const std::vector<bool> &locked = {}, DensityBasis basis = DensityBasis::Area);

} // namespace autocuts::packing
