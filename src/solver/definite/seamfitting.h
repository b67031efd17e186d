// Which edges of a seam fit each other as they are.
#pragma once

#include "solver/base/rigidfit.h"

#include <array>
#include <vector>

namespace autocuts::definite {

//! The two ends of an edge of a seam, each on both of its sides.
using EdgeMatch = std::array<PointMatch, 2>;

//! The similarity that takes the moving sides of the edges to the fixed ones.
SimilarMotion fitEdges(const std::vector<EdgeMatch> &edges);

//! True when no two sides are so far apart under the similarity of all edges that some of them cannot belong
//! together.
bool fitLoosely(const std::vector<EdgeMatch> &edges);

//! The indices of the edges whose sides lie on each other under the similarity on which most of them agree,
//! ascending. Empty when these are so few that they would fit anywhere.
std::vector<int> fittingEdges(const std::vector<EdgeMatch> &edges);

//! The indices of the edges whose sides lie on each other, but for rounding, under one similarity, ascending:
//! they were closed before an island was moved. Empty when no two of them agree.
std::vector<int> exactEdges(const std::vector<EdgeMatch> &edges);

//! The indices of the edges whose sides lie on each other as they are, ascending.
std::vector<int> touchingEdges(const std::vector<EdgeMatch> &edges);

} // namespace autocuts::definite
