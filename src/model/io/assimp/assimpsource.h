// Links Assimp's scene and the polygon soup; used by the reader and the writer.
#pragma once

#include "model/io/formats/filesource.h"

#include <Eigen/Core>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

struct aiScene;

namespace autocuts {

//! Assimp stores at most this many UV sets.
inline constexpr int maxAssimpUvSets = 8;

//! One mesh of one node of Assimp's scene, which is a range of faces and vertices of the soup.
struct AssimpPiece
{
    int node = 0;                     //!< index of the node in depth-first order
    unsigned mesh = 0;                //!< index into aiScene::mMeshes
    int firstVertex = 0;              //!< vertex i of the mesh is vertex firstVertex + i of the soup
    int firstFace = 0, faceCount = 0; //!< range of faces of the soup
    //! The transform mirrors, so the corners are in reverse order of those in the mesh.
    bool mirrored = false;
};

//! The scene as Assimp read it. Saving writes its nodes, materials, normals, bones and animations back.
struct AssimpSource : FileSource
{
    std::shared_ptr<const aiScene> scene;
    std::set<std::string> limbs; //!< nodes that the file calls bones, whether meshes have them or not
    std::map<std::string, Eigen::Matrix4d> boundAt; //!< where in the world the meshes of nodes were bound
    std::vector<AssimpPiece>
        //! In the order of the nodes and of the meshes in a node, so that faces and vertices are ascending.
        pieces;

    bool isOf(const MeshData &mesh) const override;
};

//! What Assimp's scene holds.
SourceContents contentsOf(const AssimpSource &source);

//! The corner of the soup that is the n-th of the corners of a piece in Assimp's scene, counted without
//! points and lines.
int pieceCorner(const MeshData &mesh, const AssimpPiece &piece, int n);

//! The positions of these corners in the coordinates of Assimp's mesh.
std::vector<Vec3> pieceCorners(const AssimpSource &source, const AssimpPiece &piece);

//! The name of the mesh of a piece.
std::string pieceName(const AssimpSource &source, const AssimpPiece &piece);

} // namespace autocuts
