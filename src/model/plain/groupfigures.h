// The figures of parts of a map: of its objects or its materials.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshdata.h"
#include "model/plain/uvfigures.h"

namespace autocuts::metrics {

//! The figures of one group of faces.
struct GroupFigures
{
    int faces = 0, charts = 0; //!< charts with at least one of its faces
    //! Mean over its faces with UVs, weighted by area, of the distortion of their charts, each at the scale
    //! that suits it: UvMetrics::chartSymDirichlet. 4 = isometric.
    double symDirichlet = missingFigure;
    double density = missingFigure; //!< length in UV units of a unit of the model, by the areas
    double uvArea = 0;              //!< in the map
};

//! \param charts findCharts() of the map \param uv one row per corner; a non-finite row means that the corner
//! has no UV \param faceGroup per face: its group, below count \param chartSymDirichlet
//! UvMetrics::chartSymDirichlet of this map; empty: the distortion stays missing
std::vector<GroupFigures> groupFigures(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                                       const std::vector<int> &faceGroup, int count,
                                       const std::vector<double> &chartSymDirichlet);

} // namespace autocuts::metrics
