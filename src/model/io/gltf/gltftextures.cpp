#include "model/io/gltf/gltftextures.h"

#include "model/io/gltf/gltffile.h"

#include <QUrl>

namespace autocuts {

namespace {

//! What all pictures of a file may have together: its buffer views may overlap. Chosen by hand.
constexpr qsizetype maxBytes = qsizetype(512) << 20;

} // namespace

//! The number of a texture's picture, also where an extension names it.
std::size_t GltfTextures::imageNumber(const Json &texture) const
{
    std::optional<std::size_t> source = wholeNumber(texture, "source");
    for (const char *extension : {"EXT_texture_webp", "KHR_texture_basisu"}) {
        if (!source)
            source = wholeNumber(member(member(texture, "extensions"), extension), "source");
    }
    if (!source)
        throw GltfError("a texture has no picture");
    return *source;
}

SceneTexture GltfTextures::readImage(const Json &image)
{
    const std::string uri = textOf(image, "uri");
    const QString name = QString::fromStdString(textOf(image, "name"));
    if (isDataUri(uri))
        return {name, contentOfDataUri(uri)};
    if (!uri.empty())
        return {QUrl::fromPercentEncoding(QByteArray::fromStdString(uri)), {}};
    const QByteArrayView bytes = mData.view(requiredNumber(image, "bufferView"));
    if (bytes.size() > maxBytes - mBytes)
        throw GltfError("its pictures are too large");
    mBytes += bytes.size();
    return {name, bytes.toByteArray()};
}

SceneTexture GltfTextures::ofMaterial(const Json &material)
{
    const Json *info = &member(member(material, "pbrMetallicRoughness"), "baseColorTexture");
    if (!info->is_object())
        info = &member(member(member(material, "extensions"), "KHR_materials_pbrSpecularGlossiness"),
                       "diffuseTexture");
    if (!info->is_object())
        return {};
    try {
        const Json &texture = element(mData.json(), "textures", requiredNumber(*info, "index"));
        const std::size_t number = imageNumber(texture);
        const auto found = mImages.find(number);
        if (found != mImages.end())
            return found->second;
        return mImages[number] = readImage(element(mData.json(), "images", number));
    } catch (const GltfError &) {
        return {};
    }
}

} // namespace autocuts
