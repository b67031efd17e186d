// Random steerings, and what a job must not do to them.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/unwrap/unmetsteering.h"

#include <QStringList>

#include <vector>

namespace autocuts::test {

//! A snapshot of the mesh with the map, steered at random: some of cuts, joins, painted weights, pins,
//! rectangles, locks, stacks, groups, UDIM tiles and a scope. The same seed gives the same steering.
//! \param uv per corner, texture space, without overlaps
Snapshot steered(const std::shared_ptr<const MeshData> &mesh, const UvMatrix &uv, unsigned seed);

//! What a job did.
struct Outcome
{
    UvMatrix uv;                   //!< per corner, texture space
    std::vector<bool> cut{};       //!< per edge pair; empty: where the UVs differ
    unwrap::UnmetSteering unmet{}; //!< what the job names
    bool reshapes = true;          //!< false: the job only packs, islands stay rigid
    bool saysItFailed = false;     //!< the job said that it could not do all
    bool saysSmaller = false;      //!< the job said that it made islands smaller to make room
};

//! The clauses of the steering contract that an outcome breaks; empty when it keeps them all.
QStringList broken(const Snapshot &before, const Outcome &after);

} // namespace autocuts::test
