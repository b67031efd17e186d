// The table of all actions: id, place in the menus, text, icon, default shortcut, conditions.
#pragma once

#include "views/actions/actioninfo.h"

#include <span>

namespace autocuts {

//! All actions, in the order of the menus.
std::span<const ActionInfo> actionTable();

} // namespace autocuts
