// Reads a file by Assimp's importers, in the process that calls: only autocuts-reader does, because damaged
// files can crash or hang them.
#pragma once

#include <cstdio>
#include <string>

namespace autocuts {

//! Reads a file and writes what the caller of autocuts-reader gets: see assimpstream.h.
//! \param finish ends the program with an exit code. It is called while the scene exists, because destroying
//! a damaged one can crash.
void importWithAssimp(const std::string &path, std::FILE *out, void (*finish)(int code));

} // namespace autocuts
