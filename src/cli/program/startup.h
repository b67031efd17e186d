// How the program begins: what it needs of the operating system before and beside Qt.
#pragma once

namespace autocuts {

//! Selects a UTF-8 locale when there is none, as in cron jobs and containers: Qt needs one for file names and
//! otherwise prints a warning.
void ensureUtf8Locale();
//! Closed pipes and limits of the size of files are reported as failed writes, in place of ending the
//! program.
void reportFailedWrites();
//! True when messages go to a terminal.
bool isOnTerminal();

} // namespace autocuts
