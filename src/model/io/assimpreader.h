// Reads ply, stl, off, gltf, glb, fbx, dae, 3ds and blend files through Assimp.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

namespace autocuts {

//! Reads a file as one soup in world space: texel density and packing need the true sizes, so every node's
//! transform is applied to its meshes (and the corners of mirrored ones are reversed, so that they still face
//! outwards). The scene in its own coordinates stays in the AssimpSource, and saving gives that back. Each
//! node is one object, since Assimp splits what a file calls one object by material. All UV sets are read, v
//! up. Polygons stay polygons; points and lines are left out and noted.
Result<Scene> readWithAssimp(const QString &path);

} // namespace autocuts
