// Finds the pictures of texture sets by the names of their files.
#pragma once

#include "model/document/scene.h"

#include <QStringList>

#include <optional>

namespace autocuts {

//! What the name of a picture file says.
struct NamedTexture
{
    QString stem;        //!< what is before the name of the channel, usually that of a material
    QString file;        //!< the name of the file, with <UDIM> in place of the number of a tile
    TextureSet channels; //!< several for packed pictures; with the name of the file
};

//! Understands the names that Substance, Blender, Unreal, Marmoset and the usual libraries of textures give,
//! such as wood_BaseColor.png, wood_nor_gl_4k.exr, wood_NormalDX.1001.png or wood_ORM.tga. Nothing where the
//! name tells of no channel.
std::optional<NamedTexture> textureOfName(const QString &fileName);

struct FolderTextures
{
    std::vector<TextureSet> sets; //!< as DocumentState::textureSets, with whole paths
    int pictures = 0;             //!< that were given to materials
    QStringList left;             //!< files with names of channels, but of no material of the scene
};

//! Looks through a folder, without those in it. Pictures go to the material whose name is in theirs. Where
//! no name fits, the pictures go to all materials if they have one name, or to the only material. Of several
//! pictures for a channel the first one by name is taken, of normals that for OpenGL.
FolderTextures texturesInFolder(const QString &folder, const Scene &scene);

} // namespace autocuts
