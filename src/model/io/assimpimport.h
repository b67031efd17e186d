// Reads a file by Assimp's importers, in the process that calls: only autocuts-reader does, because damaged
// files can crash or hang them.
#pragma once

#include <memory>
#include <string>

struct aiScene;

namespace autocuts {

//! \returns the scene with a root node, or null and the reason in `error` (UTF-8)
std::unique_ptr<aiScene> importWithAssimp(const std::string &path, std::string &error);

} // namespace autocuts
