// How the meshes of Assimp's scenes are bound to their bones, and what exporters need of it.
#pragma once

#include <Eigen/Geometry>

#include <optional>
#include <set>
#include <string>
#include <vector>

struct aiMesh;
struct aiNode;
struct aiScene;

namespace autocuts {

//! The names of all bones that meshes have.
std::set<std::string> boneNames(const aiScene &scene);
//! Those of the nodes with these names that lie neither above nor below a bone of a mesh.
std::set<std::string> bareBones(const aiScene &scene, const std::set<std::string> &limbs);
//! True for the node of a camera or a light.
bool isView(const aiScene &scene, const aiNode &node);
//! True when one of these bones is below a node.
bool isAboveBone(const aiNode &node, const std::set<std::string> &bones);

//! Where a node is in the world.
Eigen::Affine3d worldOf(const aiNode &node);

//! Where a mesh was in the world when it was bound; nothing without bones. Bones that are posed are not where
//! they were: the place is that which most bones agree on.
//! \param own where the mesh is now, which wins where nothing has more bones on its side
std::optional<Eigen::Affine3d> bindPlace(const aiScene &scene, const aiMesh &mesh,
                                         const Eigen::Affine3d &own);

//! Moves the skinned meshes of a node to where they were bound. What bones make of them stays the same.
//! Collada files of Assimp have no place for that of the binding, and programs take that of the mesh for it.
//! \param known where that was; null: the bones tell
void bindAtParent(const aiScene &scene, aiNode &node, const std::vector<aiMesh *> &meshes,
                  const Eigen::Matrix4d *known);

//! Gives vertices without weights a bone that lies where the node does and is not moved: glTF files do not
//! say where such vertices of a skinned mesh are. The bone is beside the topmost one.
void weighAll(const aiScene &scene, const aiNode &node, const std::vector<aiMesh *> &meshes);

//! Binds the meshes of a node below a bone to that bone, which moves them as it did. Blender loses what hangs
//! on bones of Collada files otherwise. Nodes that move by themselves stay as they are. \param bones names
//! \param animated with the animations
void bindToBone(const aiScene &animated, const aiNode &node, const std::vector<aiMesh *> &meshes,
                const std::set<std::string> &bones);

//! Makes bones without weights of the nodes below bones that hold nothing: ends of limbs, and what others are
//! moved by. Exporters take only bones of meshes for bones.
void addBonesBelow(const aiScene &scene, const std::vector<aiMesh *> &meshes);

//! Makes bones without weights of a node and all that lie between it and the bones of a mesh.
void addBonesAbove(const aiScene &scene, const aiNode &top, aiMesh &mesh);

} // namespace autocuts
