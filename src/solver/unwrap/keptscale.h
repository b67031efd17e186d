// Keeps the texel density of tiles and islands when they get a new map.
#pragma once

#include "solver/unwrap/packjob.h"

namespace autocuts::unwrap {

//! The scales of a map: per face, the length in texture space of one solver unit in its island, as the groups
//! of densityGroups() have it; not a number for faces without one.
//! \param charts of the UVs \param scale of the whole map, see layoutScale()
std::vector<double> faceScales(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv, double scale,
                               double tileHeight);

//! Per chart of a new map: the scale that most of its area had. \param scales of faceScales()
//! \param otherwise for charts without one
std::vector<double> chartScales(const MeshData &mesh, const ChartMap &charts,
                                const std::vector<double> &scales, double otherwise);

//! Scales charts about the middles of their boxes. \param factors per chart \param uv per corner
void scaleCharts(const MeshData &mesh, const ChartMap &charts, const std::vector<double> &factors,
                 UvMatrix &uv);

//! Gives the charts of a new map the scales that the snapshot's map has. Charts that packing leaves where
//! they are stay. \param scale of all charts of the new map \param uv the new map: per corner, texture space
void keepScales(const Snapshot &snapshot, const ChartMap &charts, const PackJob &pack, double scale,
                UvMatrix &uv);

//! True when a map has become noticeably smaller. \param size that it had, see layoutScale()
bool isSmaller(const MeshData &mesh, const UvMatrix &uv, double size);

} // namespace autocuts::unwrap
