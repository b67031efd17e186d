// Lists, before writing, the data that a file format cannot hold.
#pragma once

#include "model/document/scene.h"

#include <QStringList>

namespace autocuts {

//! The data of the scene that a file of this format loses, one line each; empty when nothing is lost. Takes
//! for granted that Assimp reads the polygons of an FBX file, so that a file of another format gets its
//! skeleton and animations. \param format lower-case suffix of the file to write
QStringList exportLosses(const Scene &scene, const QString &format);

//! The same, but finds that out. Waits for the program that reads the file; not for the GUI thread.
QStringList certainExportLosses(const Scene &scene, const QString &format);

} // namespace autocuts
