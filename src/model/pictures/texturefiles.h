// Finds the picture files that a model names, and the files of pictures that are one for each UDIM tile.
#pragma once

#include "model/document/scene.h"

#include <QString>

#include <map>
#include <vector>

namespace autocuts {

struct DocumentState;
struct Scene;

//! One file of a texture.
struct TextureTile
{
    int tile = 0; //!< UDIM tile; 0: the picture is for all tiles
    QString path;

    bool operator==(const TextureTile &) const = default;
};

//! The names of the files in folders. Each folder is listed once: for work on many textures.
class FolderNames
{
public:
    //! Sorted.
    const std::vector<QString> &in(const QString &folder);

private:
    std::map<QString, std::vector<QString>> mNames;
};

//! The files of a texture that exist. A name with <UDIM> in it, or with a number from 1001 to 1100 before its
//! suffix, as in wood.1001.png or wood_1001.png, is that of a set with a picture for each tile.
//! \param path as the user or findTexture() gives it \param folders null: the folder is listed anew
std::vector<TextureTile> textureTiles(const QString &path, FolderNames *folders = nullptr);

//! The path of a texture that a model names, for textureTiles(); empty when it is not there. Looked at are
//! the name in the model's folder, with its folders where they are inside of that folder or its parent, and
//! folders that are usual for textures: a model must not make us read files elsewhere.
//! \param named as the model's file spells it \param modelPath the model's file
QString findTexture(const QString &named, const QString &modelPath, FolderNames *folders = nullptr);

//! The materials that faces have, ascending; -1 for those without one.
std::vector<int> usedMaterials(const Scene &scene);

//! True when a material has a picture, whether it is there or not.
bool hasTextures(const DocumentState &state);

//! True when the picture of a channel is the user's own: its path is taken as it is. \param material -1: of
//! the faces without one
bool isChosenTexture(const DocumentState &state, int material, TextureChannel channel);

//! The scene with the user's own pictures in place of those of the model's file, for writing. Pictures
//! outside of the model's folder come along as bytes: a model must not make us read files elsewhere. Reads
//! files.
Scene withChosenTextures(Scene scene, const std::vector<TextureSet> &sets);

//! The path of a picture, for textureTiles(). What was chosen may have moved with the model. \param chosen
//! see isChosenTexture()
QString texturePath(const QString &file, bool chosen, const QString &modelPath,
                    FolderNames *folders = nullptr);

} // namespace autocuts
