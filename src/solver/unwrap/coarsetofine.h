// A map of a large mesh by way of a coarser one.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/unwrap/unwrapoptions.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace autocuts::unwrap {

struct CarriedMap
{
    SeamedMap map;
    int iterations = 0; //!< of making the coarse map
    double lambda = 0, delta = 0;
};

//! Makes the map of a coarse version of the mesh.
using CoarseUnwrap = std::function<UnwrapResult(const Snapshot &, const UnwrapOptions &)>;

//! True when the mesh is large and nothing steers single corners (pins, rectangles, existing UVs).
bool suitsCoarseToFine(const Snapshot &snapshot);

//! Coarsens the mesh (borders, cut and joined edges stay, painted weights are carried over), lets
//! `unwrapCoarse` cut and map it, carries seams and map to the fine mesh and relaxes there. No chart covers
//! itself unless overlaps are allowed. \returns nothing when the mesh cannot be coarsened or the map cannot
//! be carried over
[[nodiscard]] std::optional<CarriedMap> mapByCoarse(const std::shared_ptr<const Soup> &soup,
                                                    const Snapshot &snapshot, const UnwrapOptions &options,
                                                    const CoarseUnwrap &unwrapCoarse,
                                                    const JobContext &job = {}, int coarseTriangles = 6'000);

} // namespace autocuts::unwrap
