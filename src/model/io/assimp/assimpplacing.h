// Moves Assimp's scenes as a whole, and turns their cameras and lights as most formats have them.
#pragma once

#include <Eigen/Core>

struct aiScene;

namespace autocuts {

//! Turns, scales and moves a scene with its animations. Meshes and bones stay as they are.
void placeScene(aiScene &scene, const Eigen::Matrix4d &placement);

//! Lets cameras and lights look along -z of their nodes, with y up, as glTF and Collada have them. In FBX
//! files cameras look along x and lights along -y.
void turnViews(aiScene &scene);

} // namespace autocuts
