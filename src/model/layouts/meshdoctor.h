// Describes in sentences what is unusual about a mesh.
#pragma once

#include "model/plain/meshdata.h"

#include <QStringList>

namespace autocuts {

//! One sentence per finding: what was found and how the program handles it. Empty when nothing is unusual.
QStringList meshDoctorNotes(const MeshReport &report);

} // namespace autocuts
