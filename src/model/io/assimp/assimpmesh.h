// Converts faces of the polygon soup to a mesh for Assimp's exporters.
#pragma once

#include "model/io/assimp/assimpsource.h"

struct aiMesh;

namespace autocuts {

//! How one exported mesh is made.
struct MeshOptions
{
    const PositionMatrix *normals = nullptr; //!< per corner, for soups that were not read by Assimp
    const aiMesh *original = nullptr;        //!< the mesh of the source from which the faces came
    AssimpPiece piece;
    bool triangulate = false; //!< split polygons in the same way as MeshData
    //! Makes the file's colours of vertices of those of the original mesh, or of Scene::cornerColors without
    //! one; null: they are the same.
    float (*color)(float) = nullptr;
    //! Where positions and normals of soups go that were not read by Assimp.
    Eigen::Matrix3d place = Eigen::Matrix3d::Identity();
};

//! Makes a mesh from the given faces of the scene with all UV sets. A vertex is split where its corners
//! differ in UV or normal. Normals, colours and bones are copied from the original mesh. The caller owns the
//! result.
aiMesh *makeExportMesh(const Scene &scene, const std::vector<int> &faces, const MeshOptions &options);

} // namespace autocuts
