// The process of the reader: its limits, its end and its standard output. The only file of the reader that
// calls the operating system.
#pragma once

#include <cstdio>

namespace autocuts {

//! Ends together with the program that asked, and only by its will: Ctrl-C reaches both.
void endWithParent();
//! \param memory bytes \param seconds of the processor. Without effect on Windows
void setLimits(unsigned long long memory, unsigned long long seconds);
//! The standard output, for the scene alone: what a library prints goes nowhere. Null when that fails.
std::FILE *takeOutput();
//! Ends at once.
[[noreturn]] void endWith(int code);

} // namespace autocuts
