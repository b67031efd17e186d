#include "model/io/fbx/fbxnewmaterials.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! Properties of a material that hold pictures, as fbxtextures reads them.
constexpr std::pair<TextureChannel, const char *> pictureProperties[] = {
    {TextureChannel::BaseColor, "DiffuseColor"},      {TextureChannel::Normal, "NormalMap"},
    {TextureChannel::Roughness, "ShininessExponent"}, {TextureChannel::Metalness, "ReflectionFactor"},
    {TextureChannel::Occlusion, "AmbientColor"},      {TextureChannel::Emission, "EmissiveColor"},
    {TextureChannel::Height, "DisplacementColor"}};

//! A picture inside of the model's file stays inside of the new one, under the name that it has.
QByteArray fbxFileOf(MaterialLooks &looks, const SceneTexture &picture)
{
    if (picture.content.isEmpty())
        return looks.fileOf(picture).toUtf8();
    const QString name = QFileInfo(QString(picture.file).replace(u'\\', u'/')).completeBaseName();
    return ((name.isEmpty() ? QStringLiteral("picture") : name) + u'.' +
            pictureSuffix(picture.content, picture.file))
        .toUtf8();
}

} // namespace

//! The file of a picture, with its bytes where the model's file has them.
std::int64_t FbxNewMaterials::addPicture(const SceneTexture &picture)
{
    for (const auto &[known, id] : mPictures) {
        if (known == picture)
            return id;
    }
    const QByteArray file = fbxFileOf(mLooks, picture);
    std::vector<FbxNewNode> children{fbxLeaf("Type", QByteArray("Clip")),
                                     fbxProperties({fbxProperty("Path", "KString", "XRefUrl", {file}),
                                                    fbxProperty("RelPath", "KString", "XRefUrl", {file})}),
                                     fbxLeaf("UseMipMap", std::int32_t(0)), fbxLeaf("Filename", file),
                                     fbxLeaf("RelativeFilename", file)};
    if (!picture.content.isEmpty())
        children.push_back(fbxLeaf("Content", FbxRaw{picture.content}));
    const std::int64_t id = mObjects.add("Video", QString::fromUtf8(file), "Clip", std::move(children));
    mPictures.emplace_back(picture, id);
    return id;
}

void FbxNewMaterials::addPictures(int material)
{
    for (const auto &[channel, property] : pictureProperties) {
        const ChannelPicture entry = mLooks.picture(material, channel);
        if (entry.picture.isEmpty() || entry.component > 0)
            continue;
        const QByteArray file = fbxFileOf(mLooks, entry.picture);
        const std::int64_t video = addPicture(entry.picture);
        const std::int64_t texture = mObjects.add(
            "Texture", QString::fromUtf8(file), {},
            {fbxLeaf("Type", QByteArray("TextureVideoClip")), fbxLeaf("Version", std::int32_t(202)),
             fbxLeaf("Media", file + QByteArray("\0\1Video", 7)), fbxLeaf("FileName", file),
             fbxLeaf("RelativeFilename", file),
             fbxProperties({fbxProperty("UseMaterial", "bool", "", {std::int32_t(1)})})});
        mObjects.connect(texture, mMaterials[static_cast<std::size_t>(material)], property);
        mObjects.connect(video, texture);
    }
}

std::vector<std::int64_t> FbxNewMaterials::add()
{
    for (int m = 0; m < std::ssize(mScene.materialNames); ++m) {
        const TextureSet set = mScene.fileSet(m);
        std::vector<FbxNewNode> properties{fbxVector("DiffuseColor", "Color", mLooks.color(m))};
        // As Blender has it: the shininess of a roughness, and metal as reflection.
        if (const auto found = set.find(TextureChannel::Roughness); found != set.end())
            properties.push_back(
                fbxNumber("Shininess", std::pow(10 * (1 - std::min(found->second.factor, 1.0)), 2)));
        if (const auto found = set.find(TextureChannel::Metalness); found != set.end())
            properties.push_back(fbxNumber("ReflectionFactor", std::min(found->second.factor, 1.0)));
        const bool shiny = properties.size() > 1;
        mMaterials.push_back(
            mObjects.add("Material", mScene.materialNames[static_cast<std::size_t>(m)], {},
                         {fbxLeaf("Version", std::int32_t(102)),
                          fbxLeaf("ShadingModel", QByteArray(shiny ? "phong" : "lambert")),
                          fbxLeaf("MultiLayer", std::int32_t(0)), fbxProperties(std::move(properties))}));
        addPictures(m);
    }
    return mMaterials;
}

} // namespace autocuts
