// Animations of nodes in new Collada files, which Assimp's exporter writes in a way that other programs
// cannot read.
#pragma once

#include "model/io/assimp/assimpskeletons.h"

#include <string>
#include <string_view>

struct aiScene;

namespace autocuts {

//! The text of a Collada file with the first animation of a scene: a matrix for each key of a node, and more
//! where it turns far between two. Bones that do not move get a key, too: Blender shows those without one as
//! they were bound. Nodes are found by their names; those of skinned meshes, which bones place, are left out.
//! \param text as Assimp writes it \param changes of the nodes of the text against those of the scene
std::string withAnimations(std::string_view text, const aiScene &scene, const NodeChanges &changes);

} // namespace autocuts
