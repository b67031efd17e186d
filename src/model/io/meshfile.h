// Reading and writing mesh files of any supported format.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QStringList>

namespace autocuts {

//! Lower-case suffixes that readMesh() understands, OBJ first.
QStringList readableFormats();
//! Lower-case suffixes that writeMesh() understands, OBJ first.
QStringList writableFormats();

//! Reads a mesh file; the suffix of the path, in any case, says the format.
Result<Scene> readMesh(const QString &path);

//! An Error when writeMesh() cannot write the format that the suffix of the path says.
Result<Done> checkWriteFormat(const QString &path);

//! Writes the scene with its active (first) UV set; the suffix of the path says the format. OBJ to OBJ loses
//! nothing; for other formats see exportLosses(). On an Error an existing file is as it was.
Result<Done> writeMesh(const Scene &scene, const QString &path);

} // namespace autocuts
