// How far a cage should be from a model that a detailed one is baked to.
#pragma once

#include "model/document/documentstate.h"
#include "model/document/result.h"

#include <atomic>

namespace autocuts {

//! See transfer::proposedCage(). Reads the detailed model; takes long. \param high its file
Result<double> proposedCage(const DocumentState &model, const QString &high, const std::atomic<bool> &stop);

} // namespace autocuts
