// What Assimp leaves out of a Collada file: the names of nodes and UV sets, which nodes are bones, and the
// views of cameras.
#pragma once

#include <string_view>

struct aiScene;

namespace autocuts {

//! Gives nodes, and what refers to them, the names that people see instead of those that only the file uses,
//! UV sets those of their sources, and cameras their fields of view. Marks joints (markLimb()). \param text
//! of the file; one that is not well formed changes nothing
void completeColladaNodes(aiScene &scene, std::string_view text);

} // namespace autocuts
