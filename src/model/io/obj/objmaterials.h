// Colours and textures of the materials of OBJ files, from the files beside them (.mtl).
#pragma once

#include "model/document/scene.h"

#include <QByteArrayView>

namespace autocuts {

//! Fills in Scene::materialColors, materialTextures and materialSets from the diffuse colours (Kd) and their
//! pictures (map_Kd), and from those of the other channels, in the material files that the OBJ file names and
//! that lie in its folder. Files that are missing or too large are left out. \param bytes the OBJ file \param
//! path of that file
void readMaterials(QByteArrayView bytes, const QString &path, Scene &scene);

//! The paths of those files, there or not.
QStringList materialFiles(QByteArrayView bytes, const QString &path);

} // namespace autocuts
