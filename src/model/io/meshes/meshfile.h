// Reads and writes mesh files of all supported formats.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"
#include "model/io/formats/meshformats.h"

#include <atomic>

namespace autocuts {

//! Reads a mesh file. The suffix of the path, in upper or lower case, gives the format.
//! \param stop ends the reading with an Error when it becomes true, within 0.1 s but for the last steps of
//! building the mesh; null: never \param tileHeight of the texture that the UVs are for, see tilescaling.h
Result<Scene> readMesh(const QString &path, const std::atomic<bool> *stop = nullptr, double tileHeight = 1);

//! An Error when writeMesh() does not support the format given by the suffix.
Result<Done> checkWriteFormat(const QString &path);

//! Writes the scene with its active (first) UV set in the format given by the suffix. Writing a scene from an
//! OBJ, FBX or glTF file in its own format changes nothing but UVs; for other formats see exportLosses(). On
//! an Error an existing file is unchanged. \param tileHeight as above
Result<Done> writeMesh(const Scene &scene, const QString &path, double tileHeight = 1);

} // namespace autocuts
