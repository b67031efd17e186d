// The options of the command that bakes light.
#pragma once

#include "cli/clitable.h"

namespace autocuts {

std::vector<CliOption> lightOptions();

} // namespace autocuts
