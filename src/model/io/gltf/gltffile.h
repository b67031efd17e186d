// The bytes of a glTF 2.0 file, its containers (.glb, .gltf) and its buffers.
#pragma once

#include "model/io/gltf/gltfjson.h"

#include <QByteArray>

#include <atomic>
#include <functional>
#include <map>
#include <vector>

namespace autocuts {

//! A glTF file with the files of its buffers, as they were on disk.
struct GltfFile
{
    QByteArray main;                        //!< the .glb or .gltf file
    std::map<QByteArray, QByteArray> outer; //!< the files of buffers, by their URI as the JSON spells it

    //! True for .glb, false for .gltf; decided by the bytes.
    bool isBinary() const;
};

//! A glTF file, opened. It may share memory of the GltfFile, which must outlive it.
struct GltfDocument
{
    Json json;
    //! The content of each buffer. Buffers that only stand for decompressed data (EXT_meshopt_compression)
    //! have none.
    std::vector<QByteArray> buffers;
    QByteArray laterChunks; //!< of a .glb: what follows the JSON and the buffer, with its chunk headers
};

//! Thrown by openGltf() when it is told to stop.
struct GltfStopped
{};

//! Thrown by openGltf() for files of glTF 1.0.
struct GltfVersion1
{};

//! Takes the file apart. \param fetch gives the bytes of the file that a URI names; they are put into
//! file.outer. null: all files are there already \param stop throws GltfStopped when it becomes true; null:
//! never \throws GltfError, GltfVersion1, and what fetch throws
GltfDocument openGltf(GltfFile &file, const std::function<QByteArray(const QByteArray &uri)> &fetch = {},
                      const std::atomic<bool> *stop = nullptr);

//! The text of a .gltf file, indented as another text of JSON is.
QByteArray jsonText(const Json &json, const QByteArray &like);

//! A .glb file. The first buffer becomes its binary chunk when it has no URI; other buffers without one
//! become data URIs. \throws GltfError above 4 GB
QByteArray glbBytes(GltfDocument document);

//! The URI that contains the bytes of a buffer.
std::string dataUri(const QByteArray &bytes);

//! The bytes in a data URI. \throws GltfError when it has none
QByteArray contentOfDataUri(const std::string &uri);

//! True for URIs that contain their data.
bool isDataUri(const std::string &uri);

} // namespace autocuts
