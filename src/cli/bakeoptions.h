// The options of the command that bakes.
#pragma once

#include "cli/clioption.h"

#include <vector>

namespace autocuts {

std::vector<CliOption> bakeOptions();

} // namespace autocuts
