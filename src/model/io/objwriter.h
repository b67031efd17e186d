// The project's own OBJ writer: the original file with only its UVs changed, or a plain file.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QByteArray>

namespace autocuts {

//! The file to write. When the scene came from an OBJ file this is that file: byte for byte when the active
//! UV set is as it was read; otherwise with new vt lines in place of the old ones and new vt indices in the f
//! lines. Corners of one welded vertex with the same UV share a vt. A scene from another format gives a plain
//! file of o, v, vt, usemtl and f lines.
QByteArray objBytes(const Scene &scene);

//! Writes objBytes() atomically.
Result<Done> writeObj(const Scene &scene, const QString &path);

} // namespace autocuts
