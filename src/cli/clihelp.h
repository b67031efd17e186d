// Makes all texts about the command line from the table in clitable.h.
#pragma once

#include "cli/clioptions.h"

#include <QString>

namespace autocuts {

//! The text of --help, in lines of at most 110 characters. \param command the only one to explain; Help: all
QString usageText(CliOptions::Command command = CliOptions::Command::Help);

//! The manual page autocuts-cli(1) in roff format.
QString manualPage();

//! The tables of commands, options and exit codes for the README.
QString markdownTables();

} // namespace autocuts
