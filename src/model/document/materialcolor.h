// The colours of materials, for lists.
#pragma once

#include "model/document/scene.h"

namespace autocuts {

//! A colour from shares of red, green and blue as a picture has them; 0, which means none, when they are not
//! finite.
QRgb materialColor(double red, double green, double blue);

//! The same from shares of light, as glTF has them.
QRgb linearMaterialColor(double red, double green, double blue);

//! The base colour of a material, or one that its number always gets when the file says none.
//! \param material index into Scene::materialNames; -1: no material, which is grey
QRgb shownMaterialColor(const Scene &scene, int material);

} // namespace autocuts
