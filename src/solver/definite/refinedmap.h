// From a live solve to the final map that it stands for.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/definite/definitemap.h"

#include <functional>

namespace autocuts::definite {

struct RefinedMapOptions
{
    double maxDistortion = 4.1; //!< bound on the mean distortion, > 4
};

//! makeDefiniteMap(), and then the seam search from there: seams move, shorten and, where the bound needs it,
//! grow. Maps with pins or rectangles are not searched, because the search knows neither. Charts end up about
//! where their triangles were; they may lie over each other. When `stop` becomes true the map so far is
//! returned. \param progress told the part that is done, in [0, 1], from one thread at a time \returns
//! nothing when stopped before there was a map
[[nodiscard]] std::optional<SeamedMap>
makeRefinedMap(const homotopy::Solver &solver, const RefinedMapOptions &options, const JobContext &job = {});

} // namespace autocuts::definite
