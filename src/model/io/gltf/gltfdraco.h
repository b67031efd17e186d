// Decompresses the geometry of KHR_draco_mesh_compression.
#pragma once

#include "model/io/gltf/gltfelements.h"

#include <QByteArrayView>

#include <map>
#include <vector>

namespace autocuts {

//! A decompressed primitive.
struct DracoGeometry
{
    std::vector<std::uint32_t> corners; //!< three vertices for each triangle
    std::map<std::string, GltfElements> attributes;
};

//! Decompresses a primitive. \param primitive with the extension; its accessors say how the values are stored
//! \param root the JSON of the file \param compressed the bytes of the extension's buffer view
//! \throws GltfError
DracoGeometry decodeDraco(const Json &root, const Json &primitive, QByteArrayView compressed);

} // namespace autocuts
