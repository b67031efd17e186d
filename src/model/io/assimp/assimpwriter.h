// Writes glb, gltf, ply, dae and ASCII fbx files through Assimp.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

namespace autocuts {

//! Writes the scene with all its UV sets, the active one first, atomically. Data that the format cannot hold
//! is lost; exportLosses() lists it in advance. A glTF file contains its buffer as base64.
//! \pre the suffix of path is glb, gltf, ply, dae or fbx
Result<Done> writeWithAssimp(const Scene &scene, const QString &path);

} // namespace autocuts
