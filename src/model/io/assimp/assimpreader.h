// Reads files through Assimp: of the formats without a reader of our own and, for conversions, fbx and glTF.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <atomic>
#include <functional>

struct aiScene;

namespace autocuts {

struct AssimpSource;

//! Adds to a scene, and to what is known of it, what Assimp leaves out of its file.
using CompleteScene = std::function<void(aiScene &, AssimpSource &)>;

//! Reads a file as one polygon soup in world space: texel density and packing need the true sizes, so each
//! node's transform is applied to its meshes. The corner order of mirrored meshes is reversed, so that their
//! faces still point outwards. The scene in its own coordinates is kept in the AssimpSource and written on
//! saving. Each node becomes one object, since Assimp splits an object of the file by material. All UV sets
//! are read, with v pointing up. Polygons stay polygons; points and lines are left out and mentioned in the
//! notes.
//! \param stop ends the reading with an Error when it becomes true; null: never \param placement of the whole
//! scene, see placeScene() \param complete called before that; may be empty
Result<Scene> readWithAssimp(const QString &path, const std::atomic<bool> *stop,
                             const Eigen::Matrix4d &placement = Eigen::Matrix4d::Identity(),
                             const CompleteScene &complete = {});

} // namespace autocuts
