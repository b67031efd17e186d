// Functions of libraries that may be loaded or not.
#pragma once

namespace autocuts::linear {

//! The address of a function of the libraries that the program has loaded; null when none of them has it.
void *loadedFunction(const char *name);

} // namespace autocuts::linear
