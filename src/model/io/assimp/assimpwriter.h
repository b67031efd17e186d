// Writes files by Assimp's exporters.
#pragma once

#include "model/document/result.h"
#include "model/io/assimp/assimpscene.h"

#include <QByteArray>

#include <functional>

namespace autocuts {

//! How a format is written.
struct AssimpFormat
{
    const char *exporter; //!< Assimp's id
    ExportOptions options;
    //! Makes the bytes of the file of those that Assimp has written.
    std::function<QByteArray(const ExportScene &exported, QByteArray written)> complete;
};

//! Writes the scene with all its UV sets, the active one first, and the pictures that its materials need: all
//! or nothing. Data that the format cannot hold is lost; exportLosses() lists it in advance.
Result<Done> writeWithAssimp(const Scene &scene, const QString &path, const AssimpFormat &format);

//! Writes a PLY file.
Result<Done> writePly(const Scene &scene, const QString &path);

} // namespace autocuts
