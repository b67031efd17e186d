// What every command needs to read itself from a journal.
#pragma once

#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! The error for a command that cannot be read.
Error damagedCommand();

} // namespace autocuts
