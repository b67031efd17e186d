// Views of the cameras of FBX files, of which Assimp reads one property.
#pragma once

struct aiScene;

namespace autocuts {

class FbxLinks;
class FbxTree;

//! Gives the cameras that Assimp has read from a file of version 7 their angles, from the focal length and
//! the film or from another of the angles, and orthographic ones their width. \param metres in a unit of the
//! file
void completeFbxCameras(aiScene &scene, const FbxTree &tree, const FbxLinks &links, double metres);

} // namespace autocuts
