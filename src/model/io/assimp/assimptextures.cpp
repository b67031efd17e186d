#include "model/io/assimp/assimptextures.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>

#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/texture.h>

#include <bit>

namespace autocuts {

namespace {

//! Of a picture that the file holds as plain texels, which become a PNG file. As in picturereading.h.
constexpr unsigned maxSide = 16384;

//! A picture file, or plain texels with the width and height of the picture.
QByteArray readContent(const aiTexture &texture)
{
    if (!texture.pcData)
        return {};
    if (texture.mHeight == 0)
        return QByteArray(reinterpret_cast<const char *>(texture.pcData),
                          static_cast<qsizetype>(texture.mWidth));
    if (texture.mWidth > maxSide || texture.mHeight > maxSide)
        return {};
    static_assert(std::endian::native == std::endian::little); // aiTexel is b, g, r, a
    const QImage image(reinterpret_cast<const uchar *>(texture.pcData), static_cast<int>(texture.mWidth),
                       static_cast<int>(texture.mHeight), 4 * static_cast<qsizetype>(texture.mWidth),
                       QImage::Format_ARGB32);
    QBuffer buffer;
    return buffer.open(QIODevice::WriteOnly) && image.save(&buffer, "PNG") ? buffer.data() : QByteArray();
}

} // namespace

QByteArray AssimpTextures::contentOf(const aiTexture &texture)
{
    const auto [content, isNew] = mContents.try_emplace(&texture);
    if (isNew)
        content->second = readContent(texture);
    return content->second;
}

SceneTexture AssimpTextures::ofMaterial(const aiMaterial &material)
{
    aiString path;
    for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
        if (material.GetTexture(type, 0, &path) != AI_SUCCESS || path.length == 0)
            continue;
        const bool numbered = path.data[0] == '*';
        const aiTexture *inside = mScene.GetEmbeddedTexture(path.C_Str());
        SceneTexture texture{QString::fromUtf8(numbered ? "" : path.C_Str()), {}};
        if (inside) {
            texture.content = contentOf(*inside);
            if (numbered)
                texture.file = QString::fromUtf8(inside->mFilename.C_Str());
        }
        if (!texture.isEmpty())
            return texture;
    }
    return {};
}

} // namespace autocuts
