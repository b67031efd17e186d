// Edge weights that make seams prefer creases and hidden places.
#pragma once

#include "model/plain/snapshot.h"

namespace autocuts::preference {

//! Computes the cost factors that the settings ask for, and keeps them while the mesh and these settings stay
//! the same.
class SeamPreference
{
public:
    //! The snapshot with the rigid regions and the parts to align, and with factors multiplied into the
    //! painted weights: for creases, hidden places, and seams that tear a flat region. Unchanged when the
    //! settings ask for none of it.
    Snapshot applied(const Snapshot &snapshot, int threads = 1);

private:
    //! Cost factor per edge pair; empty when all are 1.
    const std::vector<double> &factors(const Snapshot &snapshot, int threads);

    std::shared_ptr<const MeshData> mMesh; //!< mesh of the stored factors
    SolveSettings mSettings;
    std::vector<double> mFactors;
    std::shared_ptr<const MeshData> mRigidMesh; //!< mesh of the stored regions, with its texel weights
    std::shared_ptr<const RigidRegions> mRigid;
    std::vector<int> mInFlat; //!< the edge pairs inside of flat regions
};

//! Per connected component: true where seams prefer sharp edges. Empty: nowhere.
std::vector<bool> creasedParts(const SolveSettings &settings, const MeshData &mesh);
//! Per connected component: true where islands are to run along the axes. Empty: nowhere.
std::vector<bool> alignedParts(const SolveSettings &settings, const MeshData &mesh);

//! The settings as they are for a mesh as a whole, so that they hold for a coarser version of it: creases and
//! alignment in place of Auto are On where half of its area or more is in such parts, else Off. Flat regions
//! are free on a rough surface that has hardly any.
SolveSettings decidedForAll(SolveSettings settings, const std::shared_ptr<const MeshData> &mesh);

} // namespace autocuts::preference
