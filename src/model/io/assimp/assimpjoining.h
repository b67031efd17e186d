// Meshes with several materials in new Collada files. Assimp's exporter writes a mesh for each material,
// which programs show as so many objects.
#pragma once

#include <string>
#include <string_view>
#include <vector>

struct aiScene;

namespace autocuts {

//! The faces of a joined mesh that have one material, in their order.
struct MaterialPart
{
    unsigned faces = 0, material = 0;
};

//! For each mesh of a scene: its parts; empty for those with one material.
using MaterialParts = std::vector<std::vector<MaterialPart>>;

//! Makes one mesh of those that a node has, unless bones place them differently. A scene that has been joined
//! is written with the material of the first part for all faces: withMaterials() gives the others theirs.
MaterialParts joinMeshes(aiScene &scene);

//! The text of a Collada file whose meshes were joined, with all materials. \param text as Assimp writes it
std::string withMaterials(std::string_view text, const MaterialParts &parts);

} // namespace autocuts
