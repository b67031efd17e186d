// The mesh formats that are read and written: the one list of them.
#pragma once

#include <QStringList>

#include <vector>

namespace autocuts {

//! The properties of a format that can be read.
struct MeshFormat
{
    QString suffix;   //!< in lower case
    QString mimeType; //!< as packaging/ has it
    //! The reader makes up the root of the scene for the axes and the unit of the file.
    bool hasMadeUpRoot = false;
};

//! All formats that readMesh() supports, OBJ first.
const std::vector<MeshFormat> &meshFormats();
//! True when the root of what autocuts-reader makes of a file is not from the file. \param suffix lower-case
bool hasMadeUpRoot(const QString &suffix);

//! True for the suffixes gltf and glb, in lower case.
bool isGltfFormat(const QString &format);

//! The lower-case suffixes that readMesh() supports, OBJ first.
QStringList readableFormats();
//! The lower-case suffixes that writeMesh() supports, OBJ first.
QStringList writableFormats();
//! The format to write a model in that was read from another: the same where that can be written, OBJ where
//! the format holds bare meshes, else FBX, which keeps polygons, objects, materials, bones and animations.
//! \param format lower-case suffix; may be empty
QString formatToWrite(const QString &format);

} // namespace autocuts
