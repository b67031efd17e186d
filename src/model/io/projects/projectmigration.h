// Converts the contents of older project files to the current version.
#pragma once

#include "model/io/projects/projectstate.h"

#include <functional>
#include <vector>

namespace autocuts {

//! The version of project files that this program writes.
inline constexpr int projectVersion = 2;

//! Converts the blocks of one version to those of the next; false when that is impossible. Damaged blocks are
//! missing from the map.
using Migration = std::function<bool(PartMap &parts)>;

//! The migrations by version, from 1 on. There are projectVersion - 1.
const std::vector<Migration> &projectMigrations();

//! Applies all migrations from a version on. \pre version is at least 1
//! \returns false when a migration fails, or when the version is newer than the last one
bool migrateParts(PartMap &parts, int version, const std::vector<Migration> &migrations);

} // namespace autocuts
