// Texture sets: the pictures of a material, one or more for each of its channels.
#pragma once

#include <QByteArray>
#include <QCborArray>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace autocuts {

//! A picture as a model's file names or holds it, or as the user chose it.
struct SceneTexture
{
    QString file;       //!< name or path as the file spells it; empty where it has none
    QByteArray content; //!< the bytes of a picture inside of the model's file; empty for one of its own

    bool isEmpty() const { return file.isEmpty() && content.isEmpty(); }
    bool operator==(const SceneTexture &) const = default;
};

//! Which property of a surface a picture holds. Colours (BaseColor, Emission) of whole numbers are sRGB, all
//! else and float pictures are linear.
enum class TextureChannel { BaseColor, Roughness, Metalness, Normal, Occlusion, Emission, Height };
inline constexpr int textureChannelCount = 7;

//! The picture of one channel.
struct ChannelPicture
{
    //! May name <UDIM> tiles, see textureTiles(). Empty: the channel has no picture but is `factor`
    //! everywhere.
    SceneTexture picture;
    //! Which number of the picture it is: 0 red to 3 alpha; -1: the colour, of grey channels the red.
    int component = -1;
    //! Normal: green points down, as in DirectX. Roughness: the picture is its opposite, gloss.
    bool flipped = false;
    double factor = 1; //!< that its values are multiplied by
    //! Of a set of the user: the picture is the one that the model's file has for this channel.
    bool fromModel = false;

    bool operator==(const ChannelPicture &) const = default;
};

using TextureSet = std::map<TextureChannel, ChannelPicture>;

//! The value of a channel of which nothing is known.
double neutralValue(TextureChannel channel);

//! The first set, with the channels of the second one in place of its own.
TextureSet overlaid(const TextureSet &below, const TextureSet &above);

//! The sets without the last ones that are empty.
std::vector<TextureSet> withoutEmptyEnd(std::vector<TextureSet> sets);

//! An empty string, or what is wrong: more than `most` sets, or values out of range.
QString validateTextureSets(const std::vector<TextureSet> &sets, std::size_t most);

//! For sessions and journals. The contents of pictures are left out.
QCborArray toCbor(const std::vector<TextureSet> &sets);
//! Nothing when the array is damaged or has more than `most` sets.
std::optional<std::vector<TextureSet>> readTextureSets(const QCborArray &array, std::size_t most);

} // namespace autocuts
