// Reads the arguments of the command line program by the table of commands and options.
#pragma once

#include "cli/clioptions.h"
#include "model/document/result.h"

namespace autocuts {

//! \param arguments after the program's name
//! \returns an Error for a mistake in the usage (exit code 2)
Result<CliOptions> parseCommandLine(const QStringList &arguments);

//! True when the command takes long: it can be stopped early, and keeps what it has.
bool canBeStopped(const CliOptions &options);

} // namespace autocuts
