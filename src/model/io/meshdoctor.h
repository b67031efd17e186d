// What was unusual about a mesh, in sentences.
#pragma once

#include "model/plain/meshdata.h"

#include <QStringList>

namespace autocuts {

//! One sentence per finding: what was found and how it is handled. Empty for a mesh without peculiarities.
QStringList meshDoctorNotes(const MeshReport &report);

} // namespace autocuts
