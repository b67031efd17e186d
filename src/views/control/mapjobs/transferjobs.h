// The job that brings UVs from elsewhere onto the model.
#pragma once

#include "jobs/transferchoice.h"
#include "model/document/scene.h"
#include "views/control/mapjobs/mapjobs.h"

namespace autocuts {

//! \param sets the UV sets of the document
MapJobResult transferUvsJob(const MapInput &input, const jobs::TransferChoice &choice,
                            const std::vector<UvSet> &sets, JobControl &control);

} // namespace autocuts
