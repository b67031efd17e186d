// Edits of the list of UV sets.
#pragma once

#include "commands/documentcommand.h"
#include "views/control/session/studiocontext.h"

#include <functional>

namespace autocuts {

//! Pushes a command that changes the list of UV sets, or which one is active. A solve that runs pauses first,
//! so that its map stays in the set that it was made for. Does nothing while a job runs.
void editUvSets(const StudioContext &context,
                const std::function<std::unique_ptr<DocumentCommand>(Document &)> &make);

} // namespace autocuts
