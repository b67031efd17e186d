// Nodes, cameras, lights, skins and animations of new FBX files, from what Assimp has read.
#pragma once

#include "model/io/assimp/assimpsource.h"
#include "model/io/fbx/fbxnewobjects.h"
#include "model/io/formats/freenames.h"

#include <Eigen/Geometry>

#include <map>
#include <optional>
#include <set>
#include <string>

struct aiNode;

namespace autocuts {

//! Writes a model at a place in the hierarchy. \param kind "Mesh", "Null", "LimbNode", "Camera" or "Light"
//! \param transform without shear
std::int64_t addFbxModel(FbxNewObjects &objects, const QString &name, const QByteArray &kind,
                         const Eigen::Affine3d &transform);

//! The points of a geometry and where they come from.
struct FbxSkinPoint
{
    unsigned mesh = 0, vertex = 0; //!< of Assimp's scene
};

//! The soup as Assimp has it: each mesh in the coordinates of its node.
struct AssimpPoints
{
    PositionMatrix positions;         //!< of vertices
    std::vector<FbxSkinPoint> origin; //!< of vertices
    std::vector<bool> reversed;       //!< per face: its corners are in reverse order in its mesh
    PositionMatrix normals;           //!< per corner; no rows unless all have one
    std::vector<int> nodeOfObject;    //!< numbers in depth-first order
};
AssimpPoints assimpPoints(const AssimpSource &source, const MeshData &mesh);

//! Writes the nodes of a scene.
class FbxRig final
{
public:
    //! \param fromGltf lights have the strengths of glTF
    FbxRig(FbxNewObjects &objects, const AssimpSource &source, bool fromGltf);

    //! Writes all nodes. \param name of those with an object, by the node's number in depth-first order
    void addNodes(const std::map<int, QString> &names);
    //! The model for the meshes of a node, by its number in depth-first order.
    std::int64_t model(int node) const { return mMeshModels[static_cast<std::size_t>(node)]; }
    //! Binds a geometry to the bones of its meshes. \param points of the geometry
    void addSkin(std::int64_t geometry, int node, const std::vector<FbxSkinPoint> &points);
    void addAnimations();

private:
    //! What a node is below.
    struct Above
    {
        std::int64_t model = 0;
        Eigen::Affine3d world = Eigen::Affine3d::Identity();
        std::optional<Eigen::Affine3d> armature; //!< where the skeleton is that the node belongs to
    };
    QString freeName(const QString &wanted)
    {
        return QString::fromStdString(mTaken.takeFree(wanted.toStdString()));
    }
    void addNode(const aiNode &node, const Above &above, const std::map<int, QString> &names);
    void addView(const aiNode &node, std::int64_t model);
    void addCurves(const aiNode &node, std::int64_t layer, const char *property, const char *label,
                   const std::vector<std::int64_t> &times, const std::vector<Vec3> &values);

    FbxNewObjects &mObjects;
    const AssimpSource &mSource;
    bool mFromGltf;
    std::vector<std::int64_t> mModels;     //!< of nodes
    std::vector<std::int64_t> mMeshModels; //!< of nodes, for their meshes
    std::vector<Eigen::Affine3d> mWorld;
    std::vector<Eigen::Affine3d> mMeshWorld; //!< of nodes: where their meshes are, bound ones as they were
    std::vector<Eigen::Affine3d> mArmature;  //!< of bones
    FreeNames mTaken;                        //!< names of models
    std::set<std::string> mBones;            //!< names of nodes
    std::map<std::string, std::size_t> mNumberOf; //!< of the first node of each name
    std::map<std::string, Eigen::Matrix3d>
        mTurns; //!< of cameras and lights: from Assimp's axes to those of FBX
};

} // namespace autocuts
