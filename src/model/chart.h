// Charts (UV islands): components of faces that are joined in UV space.
#pragma once

#include "model/meshdata.h"

#include <vector>

namespace autocuts {

//! The chart of every face. A face without UVs has chart -1.
struct ChartMap
{
    std::vector<int> faceChart;
    int count = 0;

    //! The faces of each chart, in rising order.
    std::vector<std::vector<int>> faces() const;
};

//! Charts by the rule of the file format: two faces on one welded 3D edge belong to one chart when their
//! UVs agree at both ends, to within 1e-6 of the diagonal of the UV box.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \pre uv.rows() == mesh.cornerCount()
ChartMap findCharts(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
