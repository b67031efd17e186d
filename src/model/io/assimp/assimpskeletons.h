// Lays the skeletons of a scene as programs that read Collada files expect them.
#pragma once

#include <Eigen/Core>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

struct aiNode;
struct aiScene;

namespace autocuts {

//! What was changed at the nodes of a scene, by their names.
struct NodeChanges
{
    std::map<std::string, Eigen::Matrix4d> before; //!< what the transforms of nodes were multiplied by
    std::set<std::string> still;                   //!< nodes whose animations do nothing, and that moved
    std::vector<aiNode *> added;
};

//! Gives z the upward direction, and to what is above skeletons no transforms: these go to what is below,
//! so that everything stays where it is. Blender turns of a file with y up only some objects when it has a
//! skeleton and none that move, and leaves out the place of what is above when it poses the bones. What is
//! above and moves becomes a bone. Meshes with bones lie below the root; Blender crashes where they are above
//! their bones. Changes nothing in scenes without bones and animations. \param animated with the animations,
//! of which the first one counts \param bare bones that no mesh has
NodeChanges layOutSkeletons(aiScene &scene, const aiScene &animated, const std::set<std::string> &bare);

//! The text of a Collada file in which bones that no mesh has are bones, too. \param text as Assimp writes it
std::string withBareBones(std::string_view text, const std::set<std::string> &bare);

} // namespace autocuts
