// Lists, before writing, the data that a file format cannot hold.
#pragma once

#include "model/document/scene.h"

#include <QStringList>

namespace autocuts {

//! The data of the scene that a file of this format loses, one line each; empty when nothing is lost.
//! \param format lower-case suffix of the file to write
QStringList exportLosses(const Scene &scene, const QString &format);

} // namespace autocuts
