// The files of a bake: the pictures it makes, and the textures it carries over.
#pragma once

#include "model/document/scene.h"
#include "model/io/picturefiles.h"
#include "model/plain/shadedsurface.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace autocuts {

//! The path of a baked map: folder/model_map.suffix, with the tile before the suffix where there are several.
QString bakedPath(const QString &folder, const QString &modelPath, const QString &map, int tile,
                  bool severalTiles, const QString &suffix);

//! A texture that is to be carried over to other UVs.
struct CarriedTexture
{
    QString path; //!< may have <UDIM> in it
    SurfaceTexture texture;
    PictureDepth depth = PictureDepth::Eight; //!< of its files
    int width = 0, height = 0;                //!< of its largest picture

    //! Where its new version goes: the name of the file in a folder. \param tile 0: it is one for all tiles
    QString newPath(const QString &folder, int tile) const;
};

//! What a texture holds, judged by words in its name ("normal", "roughness", "ao") and, where it has none, by
//! its depth: pictures of floating point numbers are linear.
TextureKind textureKindOf(const QString &path, PictureDepth depth);

//! Reads the files of a texture for all materials. Takes long.
Result<CarriedTexture> readCarriedTexture(const QString &path);

//! Where the colours of a map come from. Auto: at each point the first of them that the model has.
enum class ColorSource { Auto, Textures, Vertices, Materials };

//! Leaves a surface with the colours that are to be baked, and reads its textures if they are among them.
//! Takes long. \param surface shadedSurface() of the scene \param missing gets the names of pictures that
//! cannot be read \returns false where the model has no colours of the wanted kind
bool addColors(const Scene &scene, ColorSource from, ShadedSurface &surface, QStringList &missing);

//! Reads the pictures of the materials' base colours, as Scene::materialTextures names them. Takes long.
//! \param missing gets the names of those that cannot be read
//! \returns nothing where no material has one that can be read
std::optional<SurfaceTexture> readBaseColors(const Scene &scene, QStringList &missing);

} // namespace autocuts
