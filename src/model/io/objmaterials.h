// Colours of the materials of OBJ files, from the files beside them (.mtl).
#pragma once

#include "model/document/scene.h"

#include <QByteArrayView>

namespace autocuts {

//! Fills in Scene::materialColors from the diffuse colours (Kd) of the material files that the OBJ file names
//! and that lie in its folder. Files that are missing or too large are left out.
//! \param bytes the OBJ file \param path of that file
void readMaterialColors(QByteArrayView bytes, const QString &path, Scene &scene);

} // namespace autocuts
