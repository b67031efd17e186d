// Makes a definite map from the soup: seams decided, overlaps cut apart, needless seams closed.
#pragma once

#include "model/plain/chart.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/solver.h"

#include <optional>

namespace autocuts::definite {

struct DefiniteMapOptions
{
    //! 4.1 is the default bound of OptCuts (Li et al. 2018). The cost per length was chosen by hand.
    double maxDistortion = 4.1; //!< bound on the mean distortion when seams are closed; may be infinite
    double costPerLength = 0.1; //!< most distortion per length of seam closed, solver units
    bool allowOverlaps = false;
    //! Most Newton steps of one relaxation and most rounds of closing seams; both end earlier when nothing is
    //! gained. Chosen by hand.
    int relaxSteps = 60, joinRounds = 4;
};

struct DefiniteMap
{
    SeamedMap map;
    double seedDistortion = 0; //!< mean distortion before seams were closed: what the solver's lambda led to
};

//! The definite map of the solver's state: stitched, relaxed, without overlaps inside a chart (unless
//! allowed), with needless seams closed and, as far as pins leave it open, one texel density.
//! \returns nothing when cancelled
[[nodiscard]] std::optional<DefiniteMap> makeDefiniteMap(const homotopy::Solver &solver,
                                                         const DefiniteMapOptions &options,
                                                         const JobContext &job = {});

//! Cuts charts that overlap themselves until none does, and lays polygons that overlap themselves flat. All
//! other UVs stay as they are.
//! \return false when cancelled: then nothing was cut
[[nodiscard]] bool removeOverlaps(const Soup &soup, const Snapshot &snapshot, SeamedMap &map,
                                  const JobContext &job = {});

//! Gives every chart the texel density of the whole map. Charts that pins hold stay, and the
//! others get their density.
void equalizeDensity(const Soup &soup, const Snapshot &snapshot, SeamedMap &map);

} // namespace autocuts::definite
