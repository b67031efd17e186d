// The options of the command that bakes light.
#pragma once

#include "cli/clioption.h"

#include <vector>

namespace autocuts {

std::vector<CliOption> lightOptions();

} // namespace autocuts
