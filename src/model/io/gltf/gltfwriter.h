// Writes a model that came from a glTF file as .glb or .gltf, with nothing changed but its UVs.
#pragma once

#include "model/document/result.h"
#include "model/io/gltf/gltfsource.h"

#include <QStringList>

namespace autocuts {

//! Writes the file of the source with the UVs of the scene: see rewriteGltf(). The suffix of the path says
//! the container. A file whose UVs and container stay is written with the same bytes; only URIs change when
//! it moves to another folder: those of images lead back to the folder of the source, and the files of
//! buffers are written beside the output, before it. A changed buffer file gets the output's base name, so
//! the files of the source stay whole; with the name of the source, the old file can be used with the new
//! buffer. \pre sourceOf<GltfSource>(scene)
Result<Done> writeGltf(const Scene &scene, const QString &path);

//! The file of the source as one .glb file, with the UVs of the file. Nodes have names of
//! their own. \throws GltfError
QByteArray sourceAsGlb(const GltfSource &source);

//! What writeGltf() loses, one line each.
QStringList gltfLosses(const GltfSource &source, const Scene &scene);

} // namespace autocuts
