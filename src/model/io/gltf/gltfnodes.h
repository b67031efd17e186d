// The nodes of a glTF scene in the order in which they are drawn.
#pragma once

#include "model/io/gltf/gltfjson.h"

#include <Eigen/Core>

#include <set>
#include <string>
#include <vector>

namespace autocuts {

//! A node of the scene that has a mesh.
struct GltfMeshNode
{
    std::size_t node = 0, mesh = 0;
    Eigen::Matrix4d transform; //!< to world space
};

//! The nodes with meshes, depth first: those of the default scene, or of all when the file has no scenes.
//! Nodes that are their own descendants, or have several parents, count once. \throws GltfError
std::vector<GltfMeshNode> meshNodes(const Json &root);

//! The names of the joints of all skins, whether meshes use them or not. \throws GltfError
std::set<std::string> jointNames(const Json &root);

} // namespace autocuts
