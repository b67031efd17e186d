// Unwrapping of a large mesh by way of a coarser version of it.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/unwrap/unwrapoptions.h"

#include <functional>
#include <memory>
#include <optional>

namespace autocuts::unwrap {

//! A map of the fine mesh that was carried over from the coarse one.
struct CarriedMap
{
    SeamedMap map;
    int iterations = 0;           //!< Newton steps for the coarse map
    double lambda = 0, delta = 0; //!< of the coarse map
    int anchorFaults = 0;         //!< see search::CutState
};

//! Makes a usable map of the fine mesh from one of the coarse mesh, in a hurry: it is hardly relaxed. Nothing
//! when that fails or the job is stopped. May be kept, and called by any thread.
using CarryOver = std::function<std::optional<CarriedMap>(CarriedMap coarse, const JobContext &)>;

//! Makes a usable map of the fine mesh of what was found so far; the rest as for CarryOver.
using MakeCarriedMap = std::function<std::optional<CarriedMap>(const JobContext &)>;

//! How the map of the coarse mesh is found.
struct CoarseSearch
{
    //! Finds a map of the coarse version of a mesh; nothing when there is none that is worth being carried
    //! over. May carry over maps that it finds on the way.
    std::function<std::optional<CarriedMap>(const Snapshot &, const UnwrapOptions &, const CarryOver &)>
        unwrap;
    //! While a carried map is relaxed, receives what makes a usable map of it as it is then. May be empty.
    std::function<void(MakeCarriedMap)> relaxing;
    //! Of the coarse mesh.
    int triangles = mostCoarseTriangles;
    //! Chosen by hand.
    static constexpr int mostCoarseTriangles = 6'000;
};

//! How many triangles the coarse version of a mesh has: in drafts a sixth, from 1,500 to 6,000.
int coarseTriangles(const MeshData &mesh, UnwrapQuality quality);

//! True when the mesh has more than 25,000 triangles.
bool isLargeMesh(const MeshData &mesh);
//! True when the map is found on a coarser mesh first: of more than 25,000 triangles, in drafts of
//! about 10,000 or more that are hardly hard surface. Not when it starts from existing UVs.
bool suitsCoarseToFine(const Snapshot &snapshot, UnwrapQuality quality);

//! Coarsens the mesh, unwraps the coarse one, carries seams and map over to the fine mesh and relaxes the map
//! there; where that misses the bound, seams are added, and where stretch is left over, they get shorter.
//! Borders and the user's cut and joined edges are not collapsed; painted weights are carried over. No chart
//! overlaps itself unless overlaps are allowed. \returns nothing when the mesh cannot be coarsened far
//! enough, when the map cannot be carried over, or when the job was stopped before there was one
[[nodiscard]] std::optional<CarriedMap> mapByCoarse(const std::shared_ptr<const Soup> &soup,
                                                    const Snapshot &snapshot, const UnwrapOptions &options,
                                                    const CoarseSearch &search, const JobContext &job = {});

} // namespace autocuts::unwrap
