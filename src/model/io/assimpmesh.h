// Turns faces of the soup back into a mesh for Assimp's exporters.
#pragma once

#include "model/io/assimpsource.h"

struct aiMesh;

namespace autocuts {

//! How the faces of one exported mesh are to be read.
struct MeshOptions
{
    const PositionMatrix *normals = nullptr; //!< per corner, for soups that Assimp never saw
    const aiMesh *original = nullptr;        //!< the mesh that the piece came from
    AssimpPiece piece;
    bool triangulate = false; //!< split polygons as MeshData does
};

//! A mesh of the given faces of the scene's soup with all UV sets; vertices are split where corners differ in
//! UV or normal. Normals, colours and bones come from the original. The caller owns the result.
aiMesh *makeExportMesh(const Scene &scene, const std::vector<int> &faces, const MeshOptions &options);

} // namespace autocuts
