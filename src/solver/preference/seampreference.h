// Edge weights that make seams prefer creases and hidden places.
#pragma once

#include "model/plain/snapshot.h"

namespace autocuts::preference {

//! Computes the cost factors that the settings ask for, and keeps them while the mesh and these settings stay
//! the same.
class SeamPreference
{
public:
    //! The snapshot with the factors for creases and hidden places multiplied into the painted weights, and
    //! with the rigid regions; unchanged when the settings ask for none of it.
    Snapshot applied(const Snapshot &snapshot, int threads = 1);

private:
    //! Cost factor per edge pair; empty when all are 1.
    const std::vector<double> &factors(const Snapshot &snapshot, int threads);

    std::shared_ptr<const MeshData> mMesh; //!< mesh of the stored factors
    SolveSettings mSettings;
    std::vector<double> mFactors;
    std::shared_ptr<const MeshData> mRigidMesh; //!< mesh of the stored regions, with its texel weights
    std::shared_ptr<const RigidRegions> mRigid;
};

//! Replaces CreaseMode::Auto by On or Off, depending on whether the mesh is a hard surface; other modes are
//! returned as they are.
CreaseMode decided(CreaseMode mode, const MeshData &mesh);

} // namespace autocuts::preference
