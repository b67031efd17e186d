#include "model/io/fbx/fbxtextures.h"

#include <algorithm>
#include <array>

namespace autocuts {

namespace {

//! Properties that hold the base colour, the usual one first.
constexpr std::array<std::string_view, 8> colorProperties{"DiffuseColor",
                                                          "BaseColor",
                                                          "Maya|baseColor",
                                                          "Maya|TEX_color_map",
                                                          "Maya|DiffuseTexture",
                                                          "3dsMax|Parameters|base_color_map",
                                                          "3dsMax|parameters|base_color_map",
                                                          "Diffuse"};

//! Properties that hold other channels. Blender writes roughness and metalness as the two of Phong.
constexpr std::pair<std::string_view, TextureChannel> channelProperties[] = {
    {"NormalMap", TextureChannel::Normal},
    {"Bump", TextureChannel::Normal},
    {"Maya|normalCamera", TextureChannel::Normal},
    {"Maya|TEX_normal_map", TextureChannel::Normal},
    {"3dsMax|Parameters|bump_map", TextureChannel::Normal},
    {"3dsMax|main|norm_map", TextureChannel::Normal},
    {"ShininessExponent", TextureChannel::Roughness},
    {"Maya|specularRoughness", TextureChannel::Roughness},
    {"Maya|TEX_roughness_map", TextureChannel::Roughness},
    {"3dsMax|Parameters|roughness_map", TextureChannel::Roughness},
    {"ReflectionFactor", TextureChannel::Metalness},
    {"Maya|metalness", TextureChannel::Metalness},
    {"Maya|TEX_metallic_map", TextureChannel::Metalness},
    {"3dsMax|Parameters|metalness_map", TextureChannel::Metalness},
    {"AmbientColor", TextureChannel::Occlusion},
    {"Maya|TEX_ao_map", TextureChannel::Occlusion},
    {"EmissiveColor", TextureChannel::Emission},
    {"Maya|emissionColor", TextureChannel::Emission},
    {"Maya|TEX_emissive_map", TextureChannel::Emission},
    {"3dsMax|Parameters|emit_color_map", TextureChannel::Emission},
    {"DisplacementColor", TextureChannel::Height}};

} // namespace

void FbxTextures::addObject(std::string_view kind, const QByteArray &key, int node)
{
    if (kind == "Texture")
        mTextures.try_emplace(key, node);
    else if (kind == "Video")
        mVideos.try_emplace(key, node);
}

void FbxTextures::connect(const QByteArray &child, const QByteArray &parent, int material,
                          std::string_view property)
{
    if (mVideos.contains(child) && mTextures.contains(parent)) {
        mVideoOfTexture.try_emplace(parent, child);
    } else if (material >= 0 && mTextures.contains(child)) {
        for (const auto &[name, channel] : channelProperties) {
            if (name == property)
                mSets[material].try_emplace(channel, child);
        }
        const auto place = std::find(colorProperties.begin(), colorProperties.end(), property);
        if (place == colorProperties.end())
            return;
        const int rank = static_cast<int>(place - colorProperties.begin());
        const auto [found, isNew] = mOfMaterial.try_emplace(material, rank, child);
        if (!isNew && rank < found->second.first)
            found->second = {rank, child};
    }
}

QString FbxTextures::fileOf(int node) const
{
    for (const char *name : {"RelativeFilename", "FileName", "Filename"}) {
        const std::string_view text = mTree.text(mTree.child(node, name));
        if (!text.empty())
            return mTree.binary ? QString::fromUtf8(text.data(), std::ssize(text))
                                : QString::fromUtf8(unescapedFbx(text));
    }
    return {};
}

//! Text files hold the bytes in Base64, in one string or several.
QByteArray FbxTextures::contentOf(int video) const
{
    const int node = mTree.child(video, "Content");
    if (node < 0)
        return {};
    QByteArray content;
    const FbxNode &whole = mTree.nodes[static_cast<std::size_t>(node)];
    qint64 position = whole.valuesBegin;
    for (FbxValue value; mTree.nextValue(position, whole.valuesEnd, value);) {
        if (value.kind != FbxValue::Kind::Text)
            continue;
        const QByteArray bytes(value.text.data(), std::ssize(value.text));
        content += mTree.binary ? bytes : QByteArray::fromBase64(bytes);
    }
    return content;
}

SceneTexture FbxTextures::read(const QByteArray &key)
{
    SceneTexture result{fileOf(mTextures.at(key)), {}};
    const auto video = mVideoOfTexture.find(key);
    if (video == mVideoOfTexture.end())
        return result;
    const int node = mVideos.at(video->second);
    if (result.file.isEmpty())
        result.file = fileOf(node);
    const auto [content, isNew] = mContents.try_emplace(node);
    if (isNew)
        content->second = contentOf(node);
    result.content = content->second;
    return result;
}

std::vector<SceneTexture> FbxTextures::ofMaterials(std::size_t materials)
{
    std::vector<SceneTexture> textures(mOfMaterial.empty() ? 0 : materials);
    for (const auto &[material, texture] : mOfMaterial)
        textures[static_cast<std::size_t>(material)] = read(texture.second);
    return textures;
}

std::vector<TextureSet> FbxTextures::setsOfMaterials(std::size_t materials)
{
    std::vector<TextureSet> sets(mSets.empty() ? 0 : materials);
    for (const auto &[material, channels] : mSets) {
        for (const auto &[channel, texture] : channels)
            sets[static_cast<std::size_t>(material)][channel].picture = read(texture);
    }
    return sets;
}

} // namespace autocuts
