// What the user should know of the results of the engine's map jobs, for all who run them.
#pragma once

#include "jobs/remark.h"
#include "model/plain/snapshot.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/unwrapoptions.h"

namespace autocuts::jobs {

struct MapRemarks
{
    Remarks notes;    //!< what was done
    Remarks problems; //!< what was asked for and could not be done, the most important first
};

//! \param snapshot the input of the job. With SymmetryMode::On, it also says what is not symmetric
MapRemarks remarksOn(const Snapshot &snapshot, const unwrap::UnwrapOptions &options,
                     const unwrap::UnwrapResult &made);
//! \param stopped the job was stopped
MapRemarks remarksOn(const unwrap::FinishInput &input, const unwrap::FinishResult &made, bool stopped);
//! \param keepsScale the islands were to keep their scale
MapRemarks remarksOn(const Snapshot &snapshot, bool keepsScale, const unwrap::SeparateResult &made);

//! One remark for each kind of steering that a map does not obey.
Remarks remarksOn(const unwrap::UnmetSteering &unmet);

//! Says what of a mesh has no mirror image; nothing when all of it has. \param mirrored share of the area
Remarks remarksOnSymmetry(double mirrored);

//! Says that the islands do not fit.
Remark noRoom(bool keepsScale);

} // namespace autocuts::jobs
