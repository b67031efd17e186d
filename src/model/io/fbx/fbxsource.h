// The data of an FBX file that saving preserves.
#pragma once

#include "model/io/fbx/fbxobjects.h"
#include "model/io/formats/filesource.h"

#include <QByteArray>

#include <vector>

namespace autocuts {

//! One UV set of one geometry.
struct FbxUvElement
{
    int node = 0; //!< the LayerElementUV
    int set = 0;  //!< index into FbxSource::setNames
};

//! A geometry and where it is in the soup: once for each model that shows it.
struct FbxUse : SharedMesh
{
    int node = 0; //!< the geometry; faceCount is that of FbxGeometry::faces
    std::vector<FbxUvElement> elements;
};

//! The bytes of the file and where its UVs are. Nodes are numbered as parseFbxTree() does it.
struct FbxSource final : FileSource
{
    QByteArray bytes;
    int version = 0;
    FbxSpace space;
    std::vector<QString> setNames; //!< of the UV sets of the scene that was read
    std::vector<FbxUse> uses;
    int corners = 0; //!< of the mesh

    // In fbxanswers.cpp.
    bool isOf(const MeshData &mesh) const override;
    SceneWriter rewriter(const QString &suffix) const override;
    QStringList rewritingLosses(const Scene &scene) const override;
    Scene asRewritten(const Scene &scene, double tileHeight) const override;
    std::vector<SharedMesh> sharedMeshes(bool unique) const override;
    Result<std::shared_ptr<const FileSource>> withUniqueMeshes(const QString &path) const override;
    std::optional<double> metres() const override { return space.metres; }
    std::vector<UvSet> uvSets(const Scene &scene) const override;
    FileBlock sessionBlock() const override { return {"fbx", true}; }
    QByteArray bytesForSession() const override { return bytes; }
    ByAssimp readByAssimp() const override;
    std::optional<Scene> asAssimpReads(const Scene &scene) const override;
};

} // namespace autocuts
