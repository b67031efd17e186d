// The data of a glTF file that saving preserves.
#pragma once

#include "model/io/formats/filesource.h"
#include "model/io/gltf/gltffile.h"

#include <limits>
#include <map>
#include <vector>

namespace autocuts {

//! One primitive of one node, which is a range of faces of the soup. Its corners follow those of
//! GltfPrimitive::corners.
struct GltfPiece
{
    std::size_t mesh = 0, primitive = 0;
    int firstFace = 0, faceCount = 0;
    //! The transform mirrors, so the corners of each face are in reverse order.
    bool mirrored = false;
};

//! The file, and which of its primitives the faces of the soup are.
struct GltfSource final : FileSource
{
    GltfFile file;
    std::vector<GltfPiece> pieces;   //!< in the order of the nodes; faces are ascending
    std::vector<int> texcoords;      //!< the numbers of the UV sets in the file, ascending
    std::map<int, QString> setNames; //!< of these
    //! The first mesh that withUniqueMeshes() has added.
    std::size_t firstCopy = std::numeric_limits<std::size_t>::max();
    bool tangents = false;   //!< vertices have tangents
    bool compressed = false; //!< by KHR_draco_mesh_compression or EXT_meshopt_compression

    // In gltfanswers.cpp.
    bool isOf(const MeshData &mesh) const override;
    SceneWriter rewriter(const QString &suffix) const override;
    QStringList rewritingLosses(const Scene &scene) const override;
    std::vector<SharedMesh> sharedMeshes(bool unique) const override;
    Result<std::shared_ptr<const FileSource>> withUniqueMeshes(const QString &path) const override;
    std::vector<UvSet> uvSets(const Scene &scene) const override;
    QStringList filesBeside(const QString &path) const override;
    FileBlock sessionBlock() const override { return {"gltf", false}; }
    QByteArray bytesForSession() const override;
    std::optional<Scene> asAssimpReads(const Scene &scene) const override;
};

//! The name of the UV set of TEXCOORD_n where the file says none.
QString gltfUvSetName(int texcoord);

} // namespace autocuts
