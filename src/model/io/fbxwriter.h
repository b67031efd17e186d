// Writes new FBX files, of scenes that come from no FBX file.
#pragma once

#include "model/document/scene.h"

#include <QByteArray>

namespace autocuts {

//! A binary FBX file of version 7.4: one mesh and one model per object in world space, the materials' names,
//! all UV sets in their order, and the normals and smoothing groups of an OBJ file, as far as there are no
//! more than 32. Corners without UV have none; the axes are those of the scene, with y up.
QByteArray fbxBytes(const Scene &scene);

} // namespace autocuts
