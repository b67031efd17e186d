// The names of UV sets in a glTF file, which has only numbers for them: extras of its meshes keep them.
#pragma once

#include "model/io/gltf/gltfjson.h"

#include <QString>

#include <map>
#include <vector>

namespace autocuts {

//! The names by the numbers of the sets: those of the first mesh that names a set, or gltfUvSetName(). Each
//! name is there once.
std::map<int, QString> gltfUvNames(const Json &root, const std::vector<int> &texcoords);

//! Notes the names in all meshes; nothing when they are those that the sets have without.
void setGltfUvNames(Json &root, const std::map<int, QString> &names);

} // namespace autocuts
