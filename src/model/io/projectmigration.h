// Bringing what older versions of the program saved up to date.
#pragma once

#include "model/io/projectstate.h"

#include <functional>
#include <vector>

namespace autocuts {

//! Version of the project files that this program writes.
inline constexpr int projectVersion = 2;

//! Changes the parts of a file of one version into those of the next one; false when they do not allow it.
//! Parts that are damaged are not there.
using Migration = std::function<bool(PartMap &parts)>;

//! The one for version 1 comes first. There are projectVersion - 1 of them.
const std::vector<Migration> &projectMigrations();

//! Applies all migrations from a version on. \pre version is at least 1
//! \returns false when one of them fails, or when the version is newer than what the last one gives
bool migrateParts(PartMap &parts, int version, const std::vector<Migration> &migrations);

} // namespace autocuts
