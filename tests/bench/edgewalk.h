// Strokes over edges, for benchmarks that edit seams.
#pragma once

#include "model/plain/meshdata.h"

#include <functional>
#include <vector>

namespace autocuts::bench {

//! Edge pairs, each beginning where the one before ends, that visit no vertex twice.
//! \param isWanted which edge pairs the walk may take
//! \returns at most `count`, beginning with `first`
std::vector<int> walkEdges(const MeshData &mesh, int first, int count,
                           const std::function<bool(int)> &isWanted);

} // namespace autocuts::bench
