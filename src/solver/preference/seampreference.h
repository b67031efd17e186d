// Where seams should rather run, as weights.
#pragma once

#include "model/plain/snapshot.h"

namespace autocuts::preference {

//! Computes the factors that the settings ask for and keeps them as long as nothing of that changes.
class SeamPreference
{
public:
    //! The snapshot with the factors for creases and hidden places multiplied into the painted weights; with
    //! neither it is the same snapshot.
    Snapshot applied(const Snapshot &snapshot, int threads = 1);

private:
    //! Per edge pair; empty when all are 1.
    const std::vector<double> &factors(const Snapshot &snapshot, int threads);

    std::shared_ptr<const MeshData> mMesh; //!< that the rest is of
    SolveSettings mSettings;
    std::vector<double> mFactors;
};

//! What CreaseMode::Auto comes to on a mesh: On or Off; the other modes stay.
CreaseMode decided(CreaseMode mode, const MeshData &mesh);

} // namespace autocuts::preference
