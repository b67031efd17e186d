// The bridge between Assimp's scene and the polygon soup, used by the reader and the writer.
#pragma once

#include "model/document/scene.h"

#include <QStringList>

#include <memory>
#include <vector>

struct aiNode;
struct aiScene;

namespace autocuts {

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

//! What of the source is handed to an exporter. Assimp's exporters differ in what they get right.
struct ExportOptions
{
    bool triangulate = false; //!< as MeshData does, since Assimp's own split of concave polygons is poor
    bool animations = true;
    bool embeddedTextures = true;
    bool rootTransform = true; //!< false: the exporter ignores it, so it goes to a node below the root
};

//! The options for a format, a lower-case suffix.
ExportOptions exportOptions(const QString &format);

//! What is lost of the source when it is exported, one line each.
QStringList assimpLosses(const AssimpSource &source, const QString &format);

//! What Scene::uvSets looks like to Assimp: only so many sets.
inline constexpr int maxAssimpUvSets = 8;

//! A scene for Assimp's exporters. Nodes and materials belong to the Scene it was made from, which must live
//! longer; meshes are its own, one per piece, with vertices split where a corner differs in UV or normal.
class ExportScene
{
public:
    ExportScene(const Scene &scene, const ExportOptions &options);
    ~ExportScene();
    ExportScene(const ExportScene &) = delete;
    ExportScene &operator=(const ExportScene &) = delete;

    const aiScene *get() const { return mScene; }

private:
    void borrow(const aiScene &from);
    void takeFromSource(const Scene &scene, const AssimpSource &source);
    void makePlain(const Scene &scene);

    aiScene *mScene;
    bool mBorrowed = false; //!< materials, textures, animations, cameras and lights are the source's
    ExportOptions mOptions;
};

} // namespace autocuts
