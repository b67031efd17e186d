// Tutte's embedding of cut meshes.
#pragma once

#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::search {

//! Maps every chart of a cut mesh to a circle of the chart's area, its longest boundary loop on the circle
//! (by edge length) and its inner vertices at the weighted mean of their neighbours (weights 1 / edge
//! length). Inner loops are filled with a virtual vertex each. Positively oriented wherever the arithmetic
//! can resolve it and the chart is a disk with holes. \pre every chart has a boundary \returns coordinates
//! per soup corner, see Soup
std::vector<double> tutteEmbedding(const Soup &soup, const CutMesh &cut);

} // namespace autocuts::search
