// First cuts for the seam search: few paths, from where Tutte's embedding shrinks the surface most.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/search/cutstate.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace autocuts::search {

struct SeedOptions
{
    //! Paths added to each chart at most. A guard: shrinkage decides.
    int paths = 25;
    //! Least logarithm of 3D area over UV area at a vertex for which a path is added. See leastShrinkage of
    //! seamoptimizer.cpp.
    double shrinkage = 0.7;
    //! Begin with the seams of clusterSeams(); empty: with none.
    std::vector<double> mostSpread;
    bool joinBorders = false; //!< first join the borders of each chart by paths
    std::uint64_t seed = 1;   //!< of the random factors on the edge costs
    JobContext job;
    //! Called with the map of the cuts so far, which may be invalid, before each path that is added.
    std::function<void(const SeamedMap &)> embedded;
};

//! Opens closed charts along a path between two distant vertices and cuts charts with handles to disks. Then
//! adds paths one by one, each from the vertex that Tutte's embedding shrinks most to the nearest seam or
//! border.
//! \returns cut flags per edge pair: edges cut by the user are cut; edges joined by the user are cut only
//! where handles require it
std::vector<char> fewCuts(const SeamGraph &graph, const SeedOptions &options);

} // namespace autocuts::search
