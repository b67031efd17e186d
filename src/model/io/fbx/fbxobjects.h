// The objects of an FBX file and how they are connected.
#pragma once

#include "model/document/scene.h"
#include "model/io/fbx/fbxtree.h"
#include "model/io/formats/sourcecontents.h"

#include <QRgb>
#include <QString>

#include <Eigen/Geometry>

namespace autocuts {

//! A model: a place in the hierarchy, with geometry or without.
struct FbxModel
{
    int node = 0;
    QString name;
    int parent = -1;             //!< index of a model; -1 at the top
    bool connected = false;      //!< the file puts it into the scene
    std::vector<int> geometries; //!< nodes; of version 6 the node of the model itself
    std::vector<int> materials;  //!< indices into FbxObjects::materialNames, in the order of the slots
    std::vector<int> textures;   //!< of version 6: indices into FbxObjects::textures, as TextureId counts
};

//! A texture of the file.
struct FbxTexture
{
    QString name;
    SceneTexture picture; //!< empty when no model has it: those of materials are in materialTextures
};

struct FbxObjects
{
    std::vector<FbxModel> models; //!< in the order of the file
    std::vector<QString> materialNames;
    std::vector<QRgb> materialColors;           //!< as in Scene
    std::vector<SceneTexture> materialTextures; //!< as in Scene
    std::vector<TextureSet> materialSets;       //!< as in Scene
    std::vector<FbxTexture> textures;
    SourceContents contents;
    bool surfaces = false, curves = false, skeleton = false; //!< there are NURBS surfaces, curves, bones
};

FbxObjects readFbxObjects(const FbxTree &tree);

//! The display name of an object, of "Class::name" in text and "name\0\1Class" in binary files.
QString fbxObjectName(const FbxTree &tree, std::string_view text);

//! How the coordinates of a file lie in the world.
struct FbxSpace
{
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); //!< to x to the right, y up and z to the front; exact
    double metres = 0.01;                               //!< one unit of the file
};
FbxSpace fbxSpace(const FbxTree &tree);

//! For each model the transform from its geometry to the scene, with y up, in the unit of the file: by the
//! translations, rotations, scalings, pivots and offsets of the models and by the axes of the file. A child
//! inherits the whole transform of its parent, whatever its InheritType says.
std::vector<Eigen::Affine3d> fbxTransforms(const FbxTree &tree, const FbxObjects &objects);

} // namespace autocuts
