// Makes a refined map from a live solve: the definite map, improved by the seam search.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/definite/definitemap.h"

namespace autocuts::definite {

struct RefinedMapOptions
{
    double maxDistortion = 4.1; //!< bound on the mean distortion, > 4
};

//! makeDefiniteMap() followed by the seam search, which moves and shortens seams and adds some where the
//! bound requires it. Maps with pins or rectangles are not searched, because the search knows neither. Charts
//! stay about where their triangles were; different charts may overlap. When the job is stopped, the best map
//! so far is returned.
//! \returns nothing when stopped before there was a map
[[nodiscard]] std::optional<SeamedMap>
makeRefinedMap(const homotopy::Solver &solver, const RefinedMapOptions &options, const JobContext &job = {});

} // namespace autocuts::definite
