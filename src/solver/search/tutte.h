// Tutte's embedding (1963) of the charts of a cut mesh.
#pragma once

#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::search {

//! Maps every chart of a cut mesh to a disk of the chart's 3D area. Its longest boundary loop is laid on the
//! circle in proportion to the edge lengths; every other vertex is put at the mean of its neighbours,
//! weighted by 1 / edge length. Each inner boundary loop is filled with one virtual vertex. When a chart is a
//! disk with holes, its triangles are positively oriented as far as double precision can resolve them.
//! \pre every chart has a boundary
//! \returns coordinates per soup corner in solver units, see Soup; all charts are centred on the origin
std::vector<double> tutteEmbedding(const Soup &soup, const CutMesh &cut);

} // namespace autocuts::search
