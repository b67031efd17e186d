#include "model/io/gltf/gltflooks.h"

#include "model/io/formats/materiallooks.h"
#include "model/io/gltf/gltfappender.h"
#include "model/pictures/picturefiles.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QUrl>

#include <algorithm>
#include <span>

namespace autocuts {

namespace {

bool isWebPicture(const QByteArray &content)
{
    return content.startsWith("\x89PNG") || content.startsWith("\xff\xd8\xff");
}

//! Empty when the picture cannot be read. \param name of its file: some formats are known by nothing else
QByteArray asPng(const QByteArray &content, const QString &name)
{
    const Result<DecodedPicture> decoded = decodePicture(content, name);
    if (!decoded)
        return {};
    const Picture &picture = decoded->picture;
    const bool linear = decoded->depth == PictureDepth::Float;
    const auto byteOf = [](float value) {
        return static_cast<int>(255 * std::clamp(value, 0.0F, 1.0F) + 0.5F);
    };
    QImage image(picture.width, picture.height, QImage::Format_ARGB32);
    for (int y = 0; y < picture.height; ++y) {
        auto *line = reinterpret_cast<QRgb *>(image.scanLine(y));
        for (int x = 0; x < picture.width; ++x) {
            const std::span<const float> texel = picture.at(x, y);
            const bool colored = texel.size() >= 3, hasAlpha = texel.size() % 2 == 0;
            const auto color = [&](std::size_t k) {
                const float value = texel[colored ? k : 0];
                return byteOf(linear ? srgbFromLinear(value) : value);
            };
            line[x] = qRgba(color(0), color(1), color(2), hasAlpha ? byteOf(texel.back()) : 255);
        }
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    return buffer.open(QIODevice::WriteOnly) && image.save(&buffer, "PNG") ? bytes : QByteArray();
}

} // namespace

Json GltfPictures::imageOf(const SceneTexture &picture)
{
    const bool inside = !picture.content.isEmpty();
    QByteArray content = mLooks.contentOf(picture);
    const QString file = inside ? QString() : mLooks.fileOf(picture);
    const bool web = isWebPicture(content);
    if (!inside && (content.isEmpty() || (web && !mEmbed)))
        return {{"uri", QUrl::toPercentEncoding(file, "/!$&'()*+,;=:@").toStdString()}};
    if (!web)
        content = asPng(content, picture.file);
    if (content.isEmpty())
        return {};
    const QString name = QFileInfo(QString(picture.file).replace(u'\\', u'/')).completeBaseName();
    const std::size_t view = GltfAppender(mDocument).addPicture(content);
    Json image{{"bufferView", view},
               {"mimeType", content.startsWith("\x89PNG") ? "image/png" : "image/jpeg"}};
    if (!name.isEmpty())
        image["name"] = name.toStdString();
    return image;
}

std::optional<std::size_t> GltfPictures::add(const SceneTexture &picture)
{
    if (picture.isEmpty())
        return {};
    for (const auto &[known, texture] : mAdded) {
        if (known == picture)
            return texture;
    }
    Json image = imageOf(picture);
    if (image.is_null())
        return {};
    Json &images = mDocument.json["images"];
    images.push_back(std::move(image));
    Json &textures = mDocument.json["textures"];
    textures.push_back({{"source", images.size() - 1}});
    mAdded.emplace_back(picture, textures.size() - 1);
    return textures.size() - 1;
}

void setGltfTextures(Json &material, const TextureSet &set, int texcoord, GltfPictures &pictures)
{
    const auto entryOf = [&](TextureChannel channel) {
        const auto found = set.find(channel);
        return found == set.end() ? ChannelPicture() : found->second;
    };
    const auto put = [&](Json &owner, const char *key, const SceneTexture &picture) {
        const std::optional<std::size_t> texture = pictures.add(picture);
        if (!texture)
            return;
        Json info{{"index", *texture}};
        if (texcoord > 0)
            info["texCoord"] = texcoord;
        for (const char *kept : {"scale", "strength"}) {
            if (member(owner, key).contains(kept))
                info[kept] = owner[key][kept];
        }
        owner[key] = std::move(info);
    };
    using enum TextureChannel;
    put(material["pbrMetallicRoughness"], "baseColorTexture", entryOf(BaseColor).picture);
    const ChannelPicture rough = entryOf(Roughness), metal = entryOf(Metalness);
    const bool together = rough.picture == metal.picture && rough.component == 1 && metal.component == 2;
    if (together)
        put(material["pbrMetallicRoughness"], "metallicRoughnessTexture", rough.picture);
    put(material, "normalTexture", entryOf(Normal).picture);
    put(material, "occlusionTexture", entryOf(Occlusion).picture);
    if (!entryOf(Emission).picture.isEmpty()) {
        put(material, "emissiveTexture", entryOf(Emission).picture);
        if (!material.contains("emissiveFactor"))
            material["emissiveFactor"] = {1, 1, 1};
    }
}

} // namespace autocuts
