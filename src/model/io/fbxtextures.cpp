#include "model/io/fbxtextures.h"

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

} // namespace autocuts
