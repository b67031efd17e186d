// Writes new glTF files by Assimp.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QStringList>

namespace autocuts {

//! Writes a scene that was not read from a glTF file. The buffer of a .gltf file is inside of it.
Result<Done> writeNewGltf(const Scene &scene, const QString &path);

//! The file that a rewritten .gltf file may have for its buffer.
QStringList filesBesideGltf(const Scene &scene, const QString &path);

} // namespace autocuts
