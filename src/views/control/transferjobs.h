// The job that brings UVs from elsewhere onto the model.
#pragma once

#include "model/document/scene.h"
#include "views/control/mapjobs.h"
#include "views/control/transferchoice.h"

namespace autocuts {

//! \param sets the UV sets of the document
MapJobResult transferUvsJob(const MapInput &input, const TransferChoice &choice,
                            const std::vector<UvSet> &sets, JobControl &control);

} // namespace autocuts
