// Joins charts along their common seams where that costs little distortion.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"

#include <atomic>

namespace autocuts::definite {

//! What joining charts may cost.
struct JoinOptions
{
    double maxDistortion = 4.1; //!< no join may take the map above this (or further above it)
    double costPerLength = 0.1; //!< most distortion (mean energy) per length of seam closed (solver units)
    bool allowOverlaps = false; //!< false: no chart may come to cover itself
    int tries = 100;            //!< joins tried at most
    JobContext job;
};

//! Tries pairs of neighbouring charts, the longest common seam first: moves the smaller one rigidly onto the
//! larger one along the seam, closes the part of the seam that fits, lets the surroundings relax, and keeps
//! the result when it is worth it. Seams that the user cut stay. Returns the number of joins.
int joinCharts(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
               const JoinOptions &options);

//! Closes seams that end inside a chart, edge by edge from their ends, under the same conditions. Returns the
//! number of edges closed.
int zipSeams(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
             const JoinOptions &options);

} // namespace autocuts::definite
