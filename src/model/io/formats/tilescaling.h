// Between files, in which a tile of the texture is 1 high, and documents, in which it is as high as the
// texture is in relation to its width. So shapes in a document are those on the texture.
#pragma once

#include "model/document/scene.h"

namespace autocuts {

//! Multiplies the v of all UV sets by the height of a tile. \param tileHeight see
//! PackingSettings::tileHeight()
void scaleFromFile(Scene &scene, double tileHeight);

//! The scene with the UVs that its file gets: the inverse. UVs that are still those of the scene's file get
//! the same bits as there, whatever was rounded; where the file cannot be read again they are rounded.
Scene scaledForFile(const Scene &scene, double tileHeight);

} // namespace autocuts
