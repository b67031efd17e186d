// Formats that only Assimp writes get more from a model that our own readers read: the same file as Assimp
// reads it, with the UVs of the scene.
#pragma once

#include "model/document/scene.h"

#include <optional>

namespace autocuts {

//! The scene that Assimp read from the same file, with the UV sets of `scene`. Faces have to follow each
//! other in the same order; their corners may start elsewhere, and faces without area may be missing in
//! `scene`. Nothing when they do not correspond. \param assimp a scene of readWithAssimp()
std::optional<Scene> withUvsOf(const Scene &scene, Scene assimp);

} // namespace autocuts
