// Completes glTF files that Assimp has written: materials, cameras, lights, names of UV sets.
#pragma once

#include "model/document/scene.h"
#include "model/io/gltf/gltffile.h"

namespace autocuts {

class ExportScene;

//! \param exported what Assimp has written \param path of the file
void completeGltf(GltfDocument &document, const Scene &scene, const ExportScene &exported,
                  const QString &path);

} // namespace autocuts
