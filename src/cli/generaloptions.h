// The options that every command has.
#pragma once

#include "cli/clioption.h"

#include <vector>

namespace autocuts {

std::vector<CliOption> generalOptions();

} // namespace autocuts
