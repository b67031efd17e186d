// Motions of FBX files that Assimp leaves out or reads as others.
#pragma once

struct aiScene;

namespace autocuts {

class FbxLinks;
class FbxTree;

//! Gives animations that Assimp has read from a file of version 7 the motions of models that Assimp leaves
//! out, which are those of models with pivots. Models that turn far from one key to the next get keys
//! between: the angles of FBX say how often and which way they turn, the quaternions of Assimp do not.
//! \param scene as Assimp gives it, in the units and axes of the file
void completeFbxMotions(aiScene &scene, const FbxTree &tree, const FbxLinks &links);

} // namespace autocuts
