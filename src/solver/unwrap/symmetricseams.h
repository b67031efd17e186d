// Whether both sides of a symmetric model get the same seams, where SymmetryMode::Auto leaves that open.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/unwrap/unwrapoptions.h"

#include <optional>

namespace autocuts::unwrap {

//! True where the setting leaves it open, the model is mostly curved, and the user says nothing about seams,
//! places or what is to be straight: straightening changes seams on one side only.
bool isSymmetryOpen(const Snapshot &snapshot);

//! True when the map of the snapshot has seams, and both sides of the model have the same ones.
bool hasSymmetricSeams(const Snapshot &snapshot);

//! For a job that changes a map: On where that is asked for, and where it is open and the seams of the map
//! are symmetric, so that they stay so; otherwise Off.
SymmetryMode settledSymmetry(const Snapshot &snapshot);

//! For an unwrap: the symmetry for which it should try whether symmetric seams hardly cost more. Nothing
//! where it is not open, in drafts, and on models that are not symmetric or only nearly so. \param snapshot
//! with the preferences in its weights
std::optional<preference::MeshSymmetry> openSymmetry(const Snapshot &snapshot, const UnwrapOptions &options,
                                                     const JobContext &job);

} // namespace autocuts::unwrap
