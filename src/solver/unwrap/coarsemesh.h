// A coarser version of a mesh to be unwrapped, and the way of a map back from it.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/base/soup.h"
#include "solver/multires/progressivemesh.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace autocuts::unwrap {

//! The coarse version of a mesh, and the way back from it. Borders and the user's cut and joined edges are
//! not collapsed; painted weights are carried over.
class CoarseMesh
{
public:
    //! \param triangles that it has, or more where it cannot get coarser
    CoarseMesh(std::shared_ptr<const Soup> soup, const Snapshot &snapshot, int triangles,
               const JobContext &job);

    //! False when the mesh could hardly be coarsened, or lost its shape.
    bool isWorthIt() const;
    //! The problem on the coarse mesh: the settings, cuts, joins, weights and pins of the fine one.
    Snapshot snapshot() const;
    //! The map of the fine mesh, stitched but not relaxed; it may overlap itself. Nothing when the job is
    //! stopped. \param coarse of the coarse mesh
    std::optional<SeamedMap> carried(const SeamedMap &coarse, const JobContext &job) const;

private:
    using PointPair = std::pair<int, int>;
    //! The user's cuts and joins: per edge, given by the points at its ends, the state at each end.
    using Decisions = std::map<PointPair, std::array<std::pair<int, PairState>, 2>>;

    const std::shared_ptr<const Soup> mSoup;
    const Snapshot mSnapshot;
    const std::vector<bool> mKept;   //!< per edge pair: the user decides about it
    multires::ProgressiveMesh mMesh; //!< coarse
    const Decisions mDecisions;
    const std::vector<double> mWeights, mPreferred; //!< per point of the fine mesh
    std::shared_ptr<const MeshData> mCoarse;
    std::vector<int> mTriangles; //!< of the coarse mesh: their numbers in the fine one
};

} // namespace autocuts::unwrap
