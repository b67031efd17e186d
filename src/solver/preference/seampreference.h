// Edge weights that make seams prefer creases and hidden places.
#pragma once

#include "model/plain/snapshot.h"

namespace autocuts::preference {

//! Computes the cost factors that the settings ask for, and keeps them while the mesh and these settings stay
//! the same.
class SeamPreference
{
public:
    //! The snapshot with the factors for creases and hidden places multiplied into the painted weights, with
    //! the rigid regions and the parts to align; unchanged when the settings ask for none of it.
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

//! Per connected component: true where a mode applies. Auto: on hard surfaces. Empty: nowhere.
std::vector<bool> partsFor(CreaseMode mode, SurfaceKind kind, const MeshData &mesh);

//! Replaces CreaseMode::Auto by On or Off for the whole mesh: On where half of its area or more is in parts
//! that are hard surfaces. Other modes are returned as they are.
CreaseMode decidedForAll(CreaseMode mode, SurfaceKind kind, const MeshData &mesh);

} // namespace autocuts::preference
