// Runs the commands of the command line program; used by main() and by tests.
#pragma once

#include "cli/clioptions.h"
#include "cli/stopsource.h"

#include <QTextStream>

namespace autocuts {

//! Runs one command. Results go to `out`, progress and messages to `err`. Only commands that take long
//! (canBeStopped()) can be stopped; they then end early with the best result so far.
//! \param onTerminal whether err is a terminal
//! \returns the exit code: 0 done (also at a time limit), 1 failed, 130 interrupted
int runCommand(const CliOptions &options, StopSource &stop, bool onTerminal, QTextStream &out,
               QTextStream &err);

} // namespace autocuts
