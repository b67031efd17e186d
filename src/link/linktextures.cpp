#include "link/linktextures.h"

#include "model/document/constraints.h"

#include <QJsonObject>

#include <array>

namespace autocuts::link {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Channels as messages call them, in the order of TextureChannel.
constexpr std::array<QLatin1StringView, textureChannelCount> channelNames{
    "baseColor"_L1, "roughness"_L1, "metalness"_L1, "normal"_L1, "occlusion"_L1, "emission"_L1, "height"_L1};

} // namespace

NamedTextures NamedTextures::read(const QJsonValue &list)
{
    NamedTextures materials;
    const QJsonArray array = list.toArray();
    for (const QJsonValue &material : array) {
        materials.names.push_back(material["name"_L1].toString().left(maxNameLength));
        TextureSet &set = materials.sets.emplace_back();
        const QJsonObject textures = material["textures"_L1].toObject();
        for (std::size_t channel = 0; channel < channelNames.size(); ++channel) {
            if (const QString file = textures.value(channelNames[channel]).toString(); !file.isEmpty())
                set[TextureChannel(channel)].picture.file = file;
        }
    }
    return materials;
}

QJsonArray NamedTextures::written() const
{
    QJsonArray list;
    for (std::size_t material = 0; material < names.size(); ++material) {
        QJsonObject textures;
        for (const auto &[channel, picture] : sets[material]) {
            if (!picture.picture.file.isEmpty())
                textures.insert(channelNames[std::size_t(channel)], picture.picture.file);
        }
        list << QJsonObject{{"name"_L1, names[material]}, {"textures"_L1, textures}};
    }
    return list;
}

} // namespace autocuts::link
