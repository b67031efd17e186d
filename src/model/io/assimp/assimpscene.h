// Makes scenes for Assimp's exporters and says what scenes of its importers hold.
#pragma once

#include "model/io/assimp/assimpjoining.h"
#include "model/io/assimp/assimpskeletons.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/formats/materiallooks.h"
#include "model/io/formats/modelunits.h"

#include <QString>

#include <vector>

struct aiMesh;
struct aiNode;
struct aiScene;

namespace autocuts {

//! What an exporter is given. Assimp's exporters differ in what they write correctly.
struct ExportOptions
{
    bool triangulate = false; //!< split polygons as MeshData does; Assimp splits concave polygons badly
    bool animations = true;
    bool linearColors = false;      //!< those of vertices; otherwise they are sRGB
    bool weighsAll = false;         //!< every vertex of a skinned mesh gets weights
    bool bindsAtParent = false;     //!< skinned meshes lie where they were bound to their bones
    bool namesAllBones = false;     //!< nodes below bones are bones, with weights or without
    bool joinsMaterials = false;    //!< joinMeshes()
    bool laysOutSkeletons = false;  //!< layOutSkeletons()
    ModelUnits units;               //!< of the new file
    MaterialLooks *looks = nullptr; //!< names the pictures of materials; null: they have none
};

//! A scene for Assimp's exporters. Animations, cameras and lights belong to the Scene it was made from, which
//! must outlive it. It owns its meshes, one per AssimpPiece unless they are joined; vertices are split where
//! their corners differ in UV or normal.
class ExportScene
{
public:
    ExportScene(const Scene &scene, const ExportOptions &options);
    ~ExportScene();
    ExportScene(const ExportScene &) = delete;
    ExportScene &operator=(const ExportScene &) = delete;

    const aiScene *get() const { return mScene; }
    //! How nodes differ from those of the source.
    const NodeChanges &changes() const { return mChanges; }
    //! Bones that no mesh has.
    const std::set<std::string> &bareBones() const { return mBareBones; }
    //! Of the meshes that were joined.
    const MaterialParts &parts() const { return mParts; }

private:
    void borrow(const aiScene &from);
    void takeFromSource(const Scene &scene, const AssimpSource &source);
    void bindMeshes(const AssimpSource &source, const std::vector<aiNode *> &nodes);
    std::vector<aiMesh *> meshesOf(const aiNode &node) const;
    void makePlain(const Scene &scene);
    void makeMaterials(const Scene &scene, const aiScene *from);

    aiScene *mScene;
    bool mBorrowed = false; //!< channels of animations, cameras and lights belong to the source
    ExportOptions mOptions;
    NodeChanges mChanges;
    std::set<std::string> mBareBones;
    MaterialParts mParts;
};

} // namespace autocuts
