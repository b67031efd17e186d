// What Assimp leaves out of the nodes of a Collada file: their names and the views of cameras.
#pragma once

#include <string_view>

struct aiScene;

namespace autocuts {

//! Gives nodes, and what refers to them, the names that people see instead of those that only the file uses,
//! and cameras their fields of view. \param text of the file; one that is not well formed changes nothing
void completeColladaNodes(aiScene &scene, std::string_view text);

} // namespace autocuts
