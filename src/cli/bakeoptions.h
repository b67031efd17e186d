// The options of the command that bakes.
#pragma once

#include "cli/clioption.h"

#include <vector>

namespace autocuts {

std::vector<CliOption> bakeOptions();

//! The word for a map in options and file names, and the map.
const std::vector<std::pair<QString, bake::MapKind>> &bakedMaps();

} // namespace autocuts
