// The files that light maps are stored in.
#pragma once

#include "model/pictures/picturefiles.h"

namespace autocuts::jobs {

//! Sides of light maps. A bake keeps about 60 bytes per texel.
inline constexpr int maxLightMapSide = 8192;

//! How a light map is stored at a path, see pictureDepth(). Errors: another format, no folder to write into.
Result<PictureDepth> lightMapDepth(const QString &path, int bits);

//! Where the light map of a tile goes: with several tiles, the number stands before the suffix.
QString lightMapPath(const QString &path, int tile, bool several);

//! Adds a light map to files that are written together. Whole numbers are in sRGB. \param picture linear
Result<Done> addLightMap(Picture picture, const QString &path, PictureDepth depth, FileSet &files);

} // namespace autocuts::jobs
