// Shared by all commands that are read from a journal.
#pragma once

#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! The error for a command description that cannot be read.
Error damagedCommand();

} // namespace autocuts
