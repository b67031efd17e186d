// Joins charts along their common seams where that costs little distortion.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"

namespace autocuts::definite {

//! Limits for joining charts and zipping seams.
struct JoinOptions
{
    //! Defaults as in DefiniteMapOptions; the tries were chosen by hand.
    double maxDistortion = 4.1; //!< no join may raise the mean distortion above this, or further above it
    double costPerLength = 0.1; //!< most distortion (mean energy) per length of seam closed, solver units
    bool allowOverlaps = false; //!< false: no chart may overlap itself afterwards
    int tries = 100;            //!< most joins that are tried
    JobContext job;
};

//! Tries to join adjacent charts, the longest common seam first: moves the smaller chart rigidly onto the
//! larger one along the seam, closes the part of the seam that fits, relaxes the triangles around it, and
//! keeps the result if JoinOptions allow it. Seams that the user cut stay.
//! \return the number of joins
int joinCharts(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
               const JoinOptions &options);

//! Zips seams: closes, edge by edge, seams that end inside a chart, from their ends and under the same
//! limits.
//! \return the number of edges closed
int zipSeams(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
             const JoinOptions &options);

} // namespace autocuts::definite
