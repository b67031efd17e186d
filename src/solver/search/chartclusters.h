// First seams for surfaces of many handles and borders.
#pragma once

#include "solver/base/cutmesh.h"
#include "solver/search/seamgraph.h"

namespace autocuts::search {

//! Seams between clusters of triangles that face alike: clusters are joined as long as their normals spread
//! little beside the length of the seam between them (hierarchical face clustering, Garland et al. 2001, by
//! the L2,1 measure of Cohen-Steiner et al. 2004). Thin tubes become one cluster, thin plates one for each
//! side. Clusters below CutState::smallestChart() are joined to others as long as that spreads those little.
//! \returns cut flags per edge pair; edges cut by the user are cut, edges joined by the user are not
//! \param mostSpread per triangle: area by which the normals may spread, per length of seam, in solver units.
//! Both halves of a sphere have half its radius.
[[nodiscard]] CutFlags clusterSeams(const SeamGraph &graph, const std::vector<double> &mostSpread);

} // namespace autocuts::search
