#include "model/io/gltf/gltftextures.h"

#include "model/io/gltf/gltffile.h"

#include <QUrl>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! What all pictures of a file may have together: its buffer views may overlap. Chosen by hand.
constexpr qsizetype maxBytes = qsizetype(512) << 20;

//! A number from 0 to 100; otherwise the default.
double numberIn(const Json &object, const char *key, double byDefault)
{
    const Json &value = member(object, key);
    const double number = value.is_number() ? value.get<double>() : byDefault;
    return number >= 0 && number <= 100 ? number : byDefault;
}

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

//! \param info of a texture, as materials have them
SceneTexture GltfTextures::pictureOf(const Json &info)
{
    if (!info.is_object())
        return {};
    try {
        const Json &texture = element(mData.json(), "textures", requiredNumber(info, "index"));
        const std::size_t number = imageNumber(texture);
        const auto found = mImages.find(number);
        if (found != mImages.end())
            return found->second;
        return mImages[number] = readImage(element(mData.json(), "images", number));
    } catch (const GltfError &) {
        return {};
    }
}

SceneTexture GltfTextures::ofMaterial(const Json &material)
{
    const Json *info = &member(member(material, "pbrMetallicRoughness"), "baseColorTexture");
    if (!info->is_object())
        info = &member(member(member(material, "extensions"), "KHR_materials_pbrSpecularGlossiness"),
                       "diffuseTexture");
    return pictureOf(*info);
}

TextureSet GltfTextures::setOfMaterial(const Json &material)
{
    const Json &metallic = member(material, "pbrMetallicRoughness");
    const Json &extensions = member(material, "extensions");
    TextureSet set;
    // A material without a word about it is not taken for metal, which it would be by the specification.
    if (metallic.is_object()) {
        const SceneTexture packed = pictureOf(member(metallic, "metallicRoughnessTexture"));
        set[TextureChannel::Roughness] = {packed, 1, false, numberIn(metallic, "roughnessFactor", 1)};
        set[TextureChannel::Metalness] = {packed, 2, false, numberIn(metallic, "metallicFactor", 1)};
    }
    const auto add = [&](TextureChannel channel, const Json &info, int component, double factor) {
        if (const SceneTexture picture = pictureOf(info); !picture.isEmpty())
            set[channel] = {picture, component, false, factor};
    };
    const Json &normal = member(material, "normalTexture");
    add(TextureChannel::Normal, normal, -1, numberIn(normal, "scale", 1));
    add(TextureChannel::Occlusion, member(material, "occlusionTexture"), 0, 1);
    double emission = 0;
    if (const Json &factor = member(material, "emissiveFactor"); factor.is_array()) {
        for (const Json &value : factor)
            emission = std::max(emission, value.is_number() ? value.get<double>() : 0.0);
    }
    emission *= numberIn(member(extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1);
    if (emission > 0 && std::isfinite(emission))
        add(TextureChannel::Emission, member(material, "emissiveTexture"), -1, std::min(emission, 100.0));
    return set;
}

} // namespace autocuts
