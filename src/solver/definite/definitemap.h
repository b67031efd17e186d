// From the solver's soup to a map that can be used: seams decided, overlaps cut apart, seams closed again
// where they are not needed.
#pragma once

#include "model/plain/chart.h"
#include "solver/base/jobcontext.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/solver.h"

#include <atomic>
#include <optional>

namespace autocuts::definite {

struct DefiniteMapOptions
{
    double maxDistortion = 4.1; //!< closing seams must not take the map above this; may be infinite
    double costPerLength = 0.1; //!< distortion that a closed seam may cost per length (solver units)
    bool allowOverlaps = false;
};

struct DefiniteMap
{
    SeamedMap map;
    double seedDistortion = 0; //!< before seams were closed: what the solver's lambda led to
};

//! The definite map that the solver's state stands for: finished, relaxed, without overlaps inside a chart
//! unless they are allowed, shortened seams, and without pins and rectangles every chart at the texel density
//! of the whole. \returns nothing when cancelled
[[nodiscard]] std::optional<DefiniteMap> makeDefiniteMap(const homotopy::Solver &solver,
                                                         const DefiniteMapOptions &options,
                                                         const JobContext &job = {});

//! Cuts every chart that covers itself until none does, and lays out flat the polygons that lie on
//! themselves. Apart from these the UVs stay as they are. Returns false when cancelled: then nothing was cut.
[[nodiscard]] bool removeOverlaps(const Soup &soup, const Snapshot &snapshot, SeamedMap &map,
                                  const JobContext &job = {});

//! Gives every chart the texel density of the whole.
void equalizeDensity(const Soup &soup, SeamedMap &map);

} // namespace autocuts::definite
