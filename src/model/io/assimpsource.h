// The bridge between Assimp's scene and the polygon soup, used by the reader and the writer.
#pragma once

#include "model/document/scene.h"

#include <memory>
#include <vector>

struct aiScene;

namespace autocuts {

//! What Scene::uvSets looks like to Assimp: only so many sets.
inline constexpr int maxAssimpUvSets = 8;

//! One mesh of one node of Assimp's scene, as a run of the soup's faces and vertices.
struct AssimpPiece
{
    int node = 0;                     //!< number of the node, depth first
    unsigned mesh = 0;                //!< index into aiScene::mMeshes
    int firstVertex = 0;              //!< vertex i of the mesh is vertex firstVertex + i of the soup
    int firstFace = 0, faceCount = 0; //!< in the soup
    bool mirrored = false;            //!< corners run the other way than in the mesh: the transform mirrors
};

//! The scene as Assimp read it. Nodes, materials, normals, bones and animations are given back from here.
struct AssimpSource final : SceneSource
{
    std::shared_ptr<const aiScene> scene;
    std::vector<AssimpPiece>
        pieces; //!< by node and place in the node, so their faces and vertices are in order
};

} // namespace autocuts
