// FBX scenes for the writers of other formats, with what Assimp reads of skeletons, animations and materials.
#pragma once

#include "model/io/fbx/fbxsource.h"

#include <optional>

namespace autocuts {

//! The scene as Assimp reads the file, with the UV sets of the given one. Nothing when Assimp does not read
//! the file, or a face of the scene is not among its faces. Waits for the program that reads it; not for the
//! GUI thread. Notes the outcome in the source.
std::optional<Scene> assimpTwin(const Scene &scene, const FbxSource &source);

} // namespace autocuts
