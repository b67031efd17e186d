// Gives nodes that share a mesh one each, in a glTF file.
#pragma once

#include "model/io/gltf/gltffile.h"

namespace autocuts {

//! The file, in which each node of its scene has a mesh of its own: the first one keeps what they share, the
//! others get copies behind all other meshes. Copies share the data in the buffers. \throws GltfError
GltfFile withUniqueMeshes(const GltfFile &file);

} // namespace autocuts
