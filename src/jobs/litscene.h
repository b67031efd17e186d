// What a light bake needs of a scene, and where its pictures go.
#pragma once

#include "model/document/documentstate.h"
#include "model/io/pictures/picturefiles.h"
#include "model/plain/litsurface.h"

#include <optional>
#include <utility>
#include <vector>

namespace autocuts::jobs {

//! What reflects and what shines. Colours are linear.
struct LitSceneOptions
{
    std::vector<std::pair<QString, Vec3f>> emission; //!< radiance of materials
    std::optional<Vec3f> albedo;                     //!< of all faces
    //! A picture of it, and the UV set that it is for; no set: that of the light map. Neither a picture nor a
    //! colour: the base colours of the model, see ShadedSurface::baseColor().
    QString albedoFile, albedoUvSet;

    bool operator==(const LitSceneOptions &) const = default;
};

//! Takes long for large models and textures.
//! \param model its first UV set is the one that is baked into \param textureSet index of the UV set that the
//! textures of its materials are for \param tileHeight of the texture, see shadedSurface()
//! \param missing gets the names of textures that cannot be read
//! Errors: no UVs, no such material, no such UV set, a picture of the options that cannot be read.
Result<LitSurface> litSurface(const DocumentState &model, const LitSceneOptions &options, int textureSet,
                              double tileHeight, QStringList &missing);

//! Sides of light maps. A bake keeps about 60 bytes per texel.
inline constexpr int maxLightMapSide = 8192;

//! How a light map is stored at a path, see pictureDepth(). Errors: another format, no folder to write into.
Result<PictureDepth> lightMapDepth(const QString &path, int bits);

//! Where the light map of a tile goes: with several tiles, the number stands before the suffix.
QString lightMapPath(const QString &path, int tile, bool several);

//! Adds a light map to files that are written together; into whole numbers in sRGB. \param picture linear
Result<Done> addLightMap(Picture picture, const QString &path, PictureDepth depth, FileSet &files);

} // namespace autocuts::jobs
