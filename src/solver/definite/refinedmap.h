// Makes a refined map from a live solve: the definite map, improved by the seam search.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/definite/definitemap.h"

namespace autocuts::definite {

struct RefinedMapOptions
{
    double maxDistortion = 4.1;        //!< bound on the mean distortion, > 4
    std::optional<SeamedMap> before{}; //!< a further map to start the search from, at its place
};

struct RefinedMap
{
    SeamedMap map;
    int anchorFaults = 0; //!< see search::CutState
};

//! makeDefiniteMap() followed by the seam search, which moves and shortens seams and adds some where the
//! bound requires it. Charts that pins or rectangles hold are put exactly there; the others stay about where
//! their triangles were. Different charts may overlap. When the job is stopped, the best map so far is
//! returned.
//! \returns nothing when stopped before there was a map
[[nodiscard]] std::optional<RefinedMap>
makeRefinedMap(const homotopy::Solver &solver, const RefinedMapOptions &options, const JobContext &job = {});

} // namespace autocuts::definite
