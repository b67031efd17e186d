// What unwrapping is asked for, and what it gives.
#pragma once

#include "solver/base/seamedmap.h"
#include "solver/packing/packing.h"

#include <optional>

namespace autocuts::unwrap {

//! How much work goes into the seams.
enum class UnwrapQuality { Draft, Standard, Best };

struct UnwrapOptions
{
    double maxDistortion = 4.1;   //!< bound on the mean symmetric Dirichlet energy, > 4
    std::optional<double> lambda; //!< a fixed balance in place of the bound
    UnwrapQuality quality = UnwrapQuality::Standard;
    bool allowOverlaps = false;
    bool pack = true; //!< false: the islands stay where the solver put them
    packing::PackOptions packing;
};

struct UnwrapResult
{
    UvMatrix uv;           //!< per corner, in the unit square
    CutFlags cut;          //!< per edge pair
    double distortion = 0; //!< mean symmetric Dirichlet energy, 4 is isometric
    double seamLength = 0; //!< in solver units: seam_norm
    int iterations = 0;    //!< Newton steps of the homotopy
    double lambda = 0, delta = 0;
    bool stopped = false;    //!< cut short by `stop`: the best map until then
    bool withinBound = true; //!< false when the bound could not be reached
    //! Where it was asked for: share of the seam length that is symmetric; 0 where the mesh is not.
    std::optional<double> symmetry;
    bool packed = false; //!< false when packing was not asked for or there is no room for the margins
};

} // namespace autocuts::unwrap
