// The project's own OBJ writer: writes the original file with new UVs, or a new file.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QByteArray>
#include <QStringList>

namespace autocuts {

//! The bytes to write. For a scene from an OBJ file these are the bytes of that file when the active UV set
//! is unchanged; otherwise new vt lines replace the old ones, and f lines get new vt indices. Corners of one
//! welded vertex with the same UV share a vt line. For other scenes it is a plain file of o, v, vt, usemtl
//! and f lines.
QByteArray objBytes(const Scene &scene);

//! The files that writeObj() writes besides the path: the materials of a scene from another format.
QStringList filesBesideObj(const Scene &scene, const QString &path);

//! Writes objBytes() and what belongs to it: all or nothing.
Result<Done> writeObj(const Scene &scene, const QString &path);

} // namespace autocuts
