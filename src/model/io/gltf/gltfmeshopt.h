// Decompresses buffer views of EXT_meshopt_compression.
#pragma once

#include "model/io/gltf/gltfjson.h"

#include <QByteArray>
#include <QByteArrayView>

namespace autocuts {

//! The content of a buffer view. \param extension the EXT_meshopt_compression object of the view
//! \param compressed the bytes that it names \throws GltfError
QByteArray decodeMeshopt(const Json &extension, QByteArrayView compressed);

} // namespace autocuts
