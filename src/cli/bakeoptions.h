// The options of the command that bakes.
#pragma once

#include "cli/clitable.h"

namespace autocuts {

std::vector<CliOption> bakeOptions();

} // namespace autocuts
