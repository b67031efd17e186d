// Lays slightly curved regions in the plane with little stretch.
#pragma once

#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::rigid {

//! Moves a part of a map to a map of it that is as rigid as possible (Liu et al., "A Local/Global Approach to
//! Mesh Parameterization", 2008). What is only slightly curved has nearly the least symmetric Dirichlet
//! energy there. \param triangles of the part \param x coordinates of the soup, see Soup; those of other
//! triangles stay. The corners of one UV vertex have to be together
void flatten(const Soup &soup, const CutMesh &state, const std::vector<int> &triangles,
             std::vector<double> &x);

} // namespace autocuts::rigid
