// The files of a bake: the pictures it makes, and those it reads.
#pragma once

#include "model/document/documentstate.h"
#include "model/pictures/picturefiles.h"
#include "model/plain/shadedsurface.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace autocuts {

//! The path of a baked map: folder/model_map.suffix, with the tile before the suffix where there are several.
QString bakedPath(const QString &folder, const QString &modelPath, const QString &map, int tile,
                  bool severalTiles, const QString &suffix);

//! The pictures of a texture, and what is common to them.
struct ReadPictures
{
    TiledPicture pictures;
    PictureDepth depth = PictureDepth::Eight; //!< the largest
    int width = 0, height = 0;                //!< of the largest
};

//! Reads a content, or the files of a path as textureTiles() takes it. Takes long.
Result<ReadPictures> readPictures(const SceneTexture &texture);

//! What a texture holds, judged by words in its name ("normal", "roughness", "ao") and, where it has none, by
//! its depth: pictures of floating point numbers are linear.
TextureKind textureKindOf(const QString &path, PictureDepth depth);

//! Where the colours of a map come from. Auto: at each point the first of them that the model has.
enum class ColorSource { Auto, Textures, Vertices, Materials };

//! Leaves a surface with the colours that are to be baked, and reads its textures if they are among them.
//! Takes long. \param surface shadedSurface() of the model's scene \param missing gets the names of pictures
//! that cannot be read \returns false where the model has no colours of the wanted kind
bool addColors(const DocumentState &model, ColorSource from, ShadedSurface &surface, QStringList &missing);

//! Reads the pictures of the materials' base colours, see DocumentState::textureSet(). Takes long.
//! \param missing gets the names of those that cannot be read
//! \returns nothing where no material has one that can be read
std::optional<SurfaceTexture> readBaseColors(const DocumentState &model, QStringList &missing);

} // namespace autocuts
