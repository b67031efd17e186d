// Unwrapping by way of a coarser version of the mesh.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/unwrap/candidates.h"

#include <functional>
#include <memory>
#include <optional>

namespace autocuts::unwrap {

//! How the map of the coarse mesh is found.
struct CoarseSearch
{
    //! Finds a map of the coarse version of a mesh; nothing when there is none that is worth being carried
    //! over. May go by way of a mesh that is coarser still. What it prepares are maps of the coarse version.
    using Find =
        std::function<std::optional<Candidate>(const Snapshot &, const UnwrapOptions &, const PrepareMap &)>;
    Find find;
    int triangles = 0; //!< of the coarse mesh
};

//! True when the map is found on a coarser mesh first: that of an organic surface of more than 3,000
//! triangles (in drafts of about 10,000, but for coarse versions themselves), and of every mesh of more than
//! 25,000. Not when it starts from existing UVs; below 25,000 triangles not with a given lambda, nor, but in
//! drafts, where pins hold islands or given seams stay.
bool suitsCoarseToFine(const Snapshot &snapshot, const UnwrapOptions &options);

//! True when the mesh has more than 25,000 triangles.
bool isLargeMesh(const MeshData &mesh);
//! True when a map of the fine mesh is so far above the bound that it is not taken to it, nor would a tighter
//! bound for the coarse map help: the coarse version has lost too much of the shape.
[[nodiscard]] bool isFarAboveBound(double distortion, const UnwrapOptions &options);

//! How many triangles the coarse version has: a fifth, but 1,500 at least; for hard surface 6,000 at most.
int coarseTriangles(const Snapshot &snapshot);

//! Coarsens the mesh, unwraps the coarse one, carries seams and map over to the fine mesh and relaxes the map
//! there. Then the seams are searched on the fine mesh: where the map misses the bound, some are added, and
//! they get as short as the bound allows. No chart overlaps itself unless overlaps are allowed.
//! \param prepare gets the maps that are found on the way, without the effort of all that
//! \returns the map, not measured; nothing when the mesh cannot be coarsened far enough, when the map cannot
//! be carried over, or when the job was stopped before there was one
[[nodiscard]] std::optional<Candidate> mapByCoarse(const std::shared_ptr<const Soup> &soup,
                                                   const Snapshot &snapshot, const UnwrapOptions &options,
                                                   const CoarseSearch &search, const PrepareMap &prepare,
                                                   const JobContext &job = {});

} // namespace autocuts::unwrap
