// The scene that Assimp reads of an FBX file, with what it leaves out, for the writers of other formats.
#pragma once

#include "model/io/fbx/fbxsource.h"

#include <optional>

namespace autocuts {

//! The scene as Assimp reads the file, with the UV sets of the given one. Nothing when Assimp does not read
//! the file, or a face of the scene is not among its faces. Waits for the program that reads it; not for the
//! GUI thread.
std::optional<Scene> fbxAsAssimpReads(const Scene &scene, const FbxSource &source);

} // namespace autocuts
