// Maps to start a seam search from: few cuts, found by what a map to the disk shrinks most.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/search/cutstate.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace autocuts::search {

struct SeedOptions
{
    int paths = 25;           //!< seams added to each chart at most
    double shrinkage = 0.7;   //!< points that the embedding shrinks less get no path: logarithm of the area
    bool joinBorders = false; //!< first of all, paths between the borders of each chart
    std::uint64_t seed = 1;   //!< of the random factors on the lengths of the edges
    JobContext job;
};

//! Cuts closed charts open along a path between two far points, charts with handles to disks, then adds path
//! after path from the point that Tutte's embedding shrinks most to the nearest seam or border.
//! \returns cut flags; what the user cut is cut, what the user joined is not cut but where handles need it
std::vector<char> fewCuts(const SeamGraph &graph, const SeedOptions &options);

} // namespace autocuts::search
