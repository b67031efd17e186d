// Says before writing what a file format cannot hold.
#pragma once

#include "model/document/scene.h"

#include <QStringList>

namespace autocuts {

//! What of the scene will not be in a file of this format, one line each; empty when nothing is lost.
//! \param format lower-case suffix of the file to write
QStringList exportLosses(const Scene &scene, const QString &format);

} // namespace autocuts
