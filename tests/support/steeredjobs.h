// The jobs of the steering contract, each with little effort.
#pragma once

#include "support/meshbuilders.h"
#include "support/steerings.h"

#include <vector>

namespace autocuts::test {

//! A job that takes a steered snapshot.
struct SteeredJob
{
    const char *name;
    Outcome (*run)(const Snapshot &);
};

//! Unwrap, Finish, Separate, Pack and the live solve, which begins steered.
const std::vector<SteeredJob> &steeredJobs();
//! The second map of a live solve that began with another snapshot of the mesh and was then steered.
Outcome livedSince(const Snapshot &before, const Snapshot &snapshot);

//! The five meshes of the contract's tests.
const std::vector<const char *> &contractMeshes();
MeshPtr contractMesh(const QString &name);
//! A valid map of the mesh in several islands, per corner.
UvMatrix contractMap(const MeshPtr &mesh);
//! Random steerings per mesh. $AUTOCUTS_STEERINGS asks for more of them.
int steeringCount();

} // namespace autocuts::test
