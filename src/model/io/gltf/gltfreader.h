// The project's own reader of glTF 2.0. Together with gltfwriter it preserves everything but the UVs.
#pragma once

#include "model/document/result.h"
#include "model/io/gltf/gltfsource.h"

#include <atomic>

namespace autocuts {

//! Reads the nodes of the default scene as one polygon soup in world space, as readWithAssimp() does: one
//! object for each node, corners of mirrored meshes reversed, v pointing up. Everything else stays in the
//! GltfSource of the scene. Points, lines and triangles with wrong indices are left out and mentioned in the
//! notes. Files of glTF 1.0 are read by readWithAssimp().
//! \param stop ends the reading with an Error when it becomes true; null: never
Result<Scene> readGltf(const QString &path, const std::atomic<bool> *stop = nullptr);

//! Reads from memory; `path` is used in messages and for Scene::path.
Result<Scene> parseGltf(GltfFile file, const QString &path, const std::atomic<bool> *stop = nullptr);

} // namespace autocuts
