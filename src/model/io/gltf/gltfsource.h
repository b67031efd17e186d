// The data of a glTF file that saving preserves.
#pragma once

#include "model/document/scene.h"
#include "model/io/formats/sourcecontents.h"
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

//! What a file holds, for the messages about losses.
struct GltfContents : SourceContents
{
    bool tangents = false;   //!< vertices have tangents
    bool compressed = false; //!< by KHR_draco_mesh_compression or EXT_meshopt_compression
};

//! The file, and which of its primitives the faces of the soup are.
struct GltfSource final : SceneSource
{
    GltfFile file;
    std::vector<GltfPiece> pieces;   //!< in the order of the nodes; faces are ascending
    std::vector<int> texcoords;      //!< the numbers of the UV sets in the file, ascending
    std::map<int, QString> setNames; //!< of these
    //! The first mesh that withUniqueMeshes() has added.
    std::size_t firstCopy = std::numeric_limits<std::size_t>::max();
    GltfContents contents;
};

//! True for the suffixes gltf and glb, in lower case.
bool isGltfFormat(const QString &format);

//! The name of the UV set of TEXCOORD_n where the file says none.
QString gltfUvSetName(int texcoord);

//! The glTF source of the scene's mesh, or null.
const GltfSource *gltfSourceOf(const Scene &scene);

} // namespace autocuts
