#include "views/gl/texturelayers.h"

#include "model/pictures/texturefiles.h"
#include "model/plain/packingsettings.h"
#include "model/plain/picture.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace autocuts {

namespace {

using Channel = TextureChannel;

constexpr int layerCount = 3;
//! The slope of a step from 0 to 1 between two texels of a height, seen as normals. Chosen by hand.
constexpr float bumpSlope = 4;
//! Tiles of one set; more are left out. Chosen by hand.
constexpr std::size_t maxTiles = 80;

bool isColor(Channel channel)
{
    return channel == Channel::BaseColor || channel == Channel::Emission;
}

//! The numbers of a channel, with what is to be done to them, as a table.
std::array<uchar, 256> tableOf(Channel channel, const ChannelPicture &entry)
{
    std::array<uchar, 256> table{};
    for (int i = 0; i < 256; ++i) {
        float value = static_cast<float>(i) / 255;
        if (channel == Channel::Roughness && entry.flipped)
            value = 1 - value;
        const auto factor = static_cast<float>(entry.factor);
        value =
            isColor(channel) && factor != 1 ? srgbFromLinear(linearFromSrgb(value) * factor) : value * factor;
        table[static_cast<std::size_t>(i)] =
            value > 0 ? static_cast<uchar>(std::lround(std::min(value, 1.0F) * 255)) : uchar(0);
    }
    return table;
}

//! All four numbers of each pixel, not premultiplied, in the right size. Colours are scaled without alpha.
QImage prepared(QImage image, int component, const QSize &size)
{
    if (component == 3) {
        image = image.convertToFormat(QImage::Format_Alpha8);
        image.reinterpretAsFormat(QImage::Format_Grayscale8);
    } else {
        image = image.convertToFormat(QImage::Format_RGBA8888);
        image.reinterpretAsFormat(QImage::Format_RGBX8888);
    }
    if (image.size() != size)
        image = image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    return image.convertToFormat(QImage::Format_RGBX8888);
}

bool isGrey(const QImage &image)
{
    return image.format() == QImage::Format_Grayscale8 || image.format() == QImage::Format_Grayscale16 ||
           image.allGray();
}

uchar normalByte(float value)
{
    return static_cast<uchar>(std::lround(std::clamp(value, -1.0F, 1.0F) * 127 + 128));
}

//! Layer and place in its pixels.
std::pair<int, int> placeOf(Channel channel)
{
    switch (channel) {
    case Channel::BaseColor:
        return {0, 0};
    case Channel::Height:
        return {0, 3};
    case Channel::Normal:
        return {1, 0};
    case Channel::Roughness:
        return {1, 2};
    case Channel::Metalness:
        return {1, 3};
    case Channel::Emission:
        return {2, 0};
    case Channel::Occlusion:
        break;
    }
    return {2, 3};
}

//! A tile of a set: images of its channels, then the layers that are packed from them.
class Packer
{
public:
    Packer(const TextureSetRequest &request, const QSize &size) : mRequest(request), mSize(size)
    {
        for (QImage &layer : mLayers)
            layer = QImage(size, QImage::Format_RGBA8888);
        mLayers[0].fill(QColor(request.color == 0 ? qRgb(200, 200, 200) : request.color));
        mLayers[1].fill(QColor(128, 128, 0));
        mLayers[2].fill(Qt::black);
        setConstants();
    }

    void add(Channel channel, const QImage &image)
    {
        const ChannelPicture &entry = mRequest.channels.at(channel).entry;
        const bool bump = channel == Channel::Normal && entry.component < 0 && isGrey(image);
        const QImage pixels = prepared(image, entry.component, mSize);
        const int component = entry.component == 3 ? 0 : std::max(entry.component, 0);
        if (channel == Channel::Normal) {
            mHasNormals = true;
            bump ? addBump(pixels, 0, static_cast<float>(entry.factor)) : addNormals(pixels, entry);
            return;
        }
        const std::array<uchar, 256> table = tableOf(channel, entry);
        const auto [layer, place] = placeOf(channel);
        const int count = isColor(channel) ? 3 : 1;
        const bool repeats = isColor(channel) && entry.component >= 0;
        for (int y = 0; y < mSize.height(); ++y) {
            const uchar *in = pixels.constScanLine(y);
            uchar *out = mLayers[static_cast<std::size_t>(layer)].scanLine(y) + place;
            for (int x = 0; x < mSize.width(); ++x, in += 4, out += 4) {
                for (int k = 0; k < count; ++k)
                    out[k] = table[in[count == 1 || repeats ? component : k]];
            }
        }
        if (channel == Channel::Height)
            mHeight = pixels;
    }

    std::array<QImage, layerCount> layers()
    {
        if (!mHasNormals && !mHeight.isNull())
            addBump(mHeight, std::max(0, mRequest.channels.at(Channel::Height).entry.component % 3), 1);
        return mLayers;
    }

private:
    void setConstants()
    {
        for (const Channel channel :
             {Channel::Height, Channel::Roughness, Channel::Metalness, Channel::Occlusion}) {
            const auto found = mRequest.channels.find(channel);
            const double value =
                found == mRequest.channels.end() ? neutralValue(channel) : found->second.entry.factor;
            const auto byte = static_cast<uchar>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
            const auto [layer, place] = placeOf(channel);
            for (int y = 0; y < mSize.height(); ++y) {
                uchar *out = mLayers[static_cast<std::size_t>(layer)].scanLine(y) + place;
                for (int x = 0; x < mSize.width(); ++x)
                    out[4 * x] = byte;
            }
        }
    }

    void addNormals(const QImage &pixels, const ChannelPicture &entry)
    {
        const auto factor = static_cast<float>(entry.factor);
        for (int y = 0; y < mSize.height(); ++y) {
            const uchar *in = pixels.constScanLine(y);
            uchar *out = mLayers[1].scanLine(y);
            for (int x = 0; x < mSize.width(); ++x, in += 4, out += 4) {
                const float up = (static_cast<float>(in[1]) - 127.5F) / 127.5F;
                out[0] = normalByte(factor * (static_cast<float>(in[0]) - 127.5F) / 127.5F);
                out[1] = normalByte(factor * (entry.flipped ? -up : up));
            }
        }
    }

    void addBump(const QImage &pixels, int component, float factor)
    {
        const int width = mSize.width(), height = mSize.height();
        const auto at = [&](int x, int y) {
            return static_cast<float>(
                       pixels.constScanLine((y + height) % height)[4 * ((x + width) % width) + component]) /
                   255;
        };
        for (int y = 0; y < height; ++y) {
            uchar *out = mLayers[1].scanLine(y);
            for (int x = 0; x < width; ++x, out += 4) {
                const float dx = factor * bumpSlope * 0.5F * (at(x - 1, y) - at(x + 1, y));
                const float dy = factor * bumpSlope * 0.5F * (at(x, y + 1) - at(x, y - 1));
                const float length = std::sqrt(dx * dx + dy * dy + 1);
                out[0] = normalByte(dx / length);
                out[1] = normalByte(dy / length);
            }
        }
    }

    const TextureSetRequest &mRequest;
    QSize mSize;
    std::array<QImage, layerCount> mLayers;
    QImage mHeight;
    bool mHasNormals = false;
};

//! The files of all channels of a set.
struct SetFiles
{
    std::map<Channel, std::vector<TextureTile>> files;
    std::set<int> tiles; //!< numbers; 0: for all tiles
};

SetFiles filesOf(const TextureSetRequest &request)
{
    SetFiles result;
    for (const auto &[channel, wanted] : request.channels) {
        std::vector<TextureTile> files;
        if (!wanted.picture.content.isEmpty())
            files.push_back({0, {}});
        else if (!wanted.picture.path.isEmpty())
            files = textureTiles(wanted.picture.path);
        for (const TextureTile &file : files)
            result.tiles.insert(file.tile);
        result.files[channel] = std::move(files);
    }
    // A picture for all tiles is only shown as such where no channel has tiles.
    if (result.tiles.size() > 1)
        result.tiles.erase(0);
    while (result.tiles.size() > maxTiles)
        result.tiles.erase(std::prev(result.tiles.end()));
    return result;
}

class SetReading
{
public:
    SetReading(int longest, QStringList &problems, const std::atomic<bool> *stop)
        : mLongest(longest), mProblems(problems), mStop(stop)
    {
        mPictures.layers = layerCount;
    }

    void add(const TextureSetRequest &request, const SetFiles &files)
    {
        Pictures::Set set;
        for (const int tile : files.tiles) {
            std::map<Channel, QImage> images;
            for (const auto &[channel, wanted] : request.channels) {
                if (QImage image = read(wanted, channel, files.files.at(channel), tile); !image.isNull())
                    images[channel] = std::move(image);
            }
            if (images.empty() || stopped())
                continue;
            for (const auto &[channel, image] : images)
                mSize = mSize.expandedTo(image.size());
            (tile == 0 ? set.repeated : set.tiles[tile - PackingSettings::firstTile]) =
                static_cast<int>(mTiles.size());
            mTiles.push_back({&request, std::move(images)});
        }
        for (const auto &[channel, wanted] : request.channels) {
            if (wanted.picture.name.isEmpty() || !files.files.at(channel).empty())
                continue;
            addProblem(wanted, QCoreApplication::translate("Pictures", "not found"));
        }
        mPictures.sets.push_back(set);
        mRead.clear();
    }

    //! Packs what was read.
    Pictures result()
    {
        if (mTiles.empty() || stopped())
            return {layerCount, {}, std::vector<Pictures::Set>(mPictures.sets.size())};
        for (Tile &tile : mTiles) {
            Packer packer(*tile.request, mSize);
            for (const auto &[channel, image] : tile.images)
                packer.add(channel, image);
            tile.images.clear();
            for (QImage &layer : packer.layers())
                mPictures.images.push_back(std::move(layer));
        }
        for (Pictures::Set &set : mPictures.sets) {
            set.repeated = set.repeated < 0 ? -1 : layerCount * set.repeated;
            for (auto &[place, number] : set.tiles)
                number *= layerCount;
        }
        return std::move(mPictures);
    }

private:
    struct Tile
    {
        const TextureSetRequest *request;
        std::map<Channel, QImage> images;
    };

    bool stopped() const { return mStop && *mStop; }

    void addProblem(const TextureSetRequest::Channel &wanted, const QString &problem)
    {
        const QString line = QStringLiteral("%1 (%2)").arg(wanted.picture.name, problem);
        if (!mProblems.contains(line))
            mProblems << line;
    }

    //! The image of a channel in a tile. Packed channels are read once.
    QImage read(const TextureSetRequest::Channel &wanted, Channel channel,
                const std::vector<TextureTile> &files, int tile)
    {
        const auto file = std::find_if(files.begin(), files.end(), [&](const TextureTile &each) {
            return each.tile == tile || each.tile == 0;
        });
        if (file == files.end() || stopped())
            return {};
        const PictureNumbers numbers = isColor(channel) ? PictureNumbers::Color : PictureNumbers::Plain;
        const auto [found, isNew] =
            mRead.try_emplace({file->path, wanted.picture.content.constData(), numbers});
        if (isNew) {
            QString problem;
            found->second = readImage({file->path, wanted.picture.content, {}}, mLongest, numbers, problem);
            if (!problem.isEmpty() && !stopped())
                addProblem(wanted, problem);
        }
        return found->second;
    }

    int mLongest;
    QStringList &mProblems;
    const std::atomic<bool> *mStop;
    Pictures mPictures;
    QSize mSize{1, 1};
    std::vector<Tile> mTiles;
    std::map<std::tuple<QString, const char *, PictureNumbers>, QImage> mRead; //!< of one set
};

} // namespace

Pictures readTextureSets(const std::vector<TextureSetRequest> &requests, QStringList &problems,
                         const std::atomic<bool> *stop)
{
    std::vector<SetFiles> files;
    std::size_t tiles = 0;
    for (const TextureSetRequest &request : requests) {
        files.push_back(filesOf(request));
        tiles += files.back().tiles.size();
    }
    // While they are packed, the pictures that were read are there as well.
    SetReading reading(longestSide((layerCount + 3) * tiles), problems, stop);
    for (std::size_t r = 0; r < requests.size(); ++r)
        reading.add(requests[r], files[r]);
    return reading.result();
}

QImage channelImage(const Pictures &pictures, int first, TextureChannel channel, int side)
{
    const auto [layer, place] = placeOf(channel);
    const bool color = channel == Channel::BaseColor || (pictures.layers == layerCount && isColor(channel));
    const auto number = static_cast<std::size_t>(first + layer);
    if ((pictures.layers == 1 && channel != Channel::BaseColor) || number >= pictures.images.size())
        return {};
    const QImage &image = pictures.images[number];
    QImage result(side, side, QImage::Format_RGB32);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int column = x * image.width() / side, row = y * image.height() / side;
            if (pictures.layers == 1) {
                result.setPixel(x, y, image.pixel(column, row));
                continue;
            }
            const uchar *pixel = image.constScanLine(row) + 4 * column;
            const int grey = pixel[place];
            result.setPixel(x, y,
                            color                        ? qRgb(pixel[0], pixel[1], pixel[2])
                            : channel == Channel::Normal ? qRgb(pixel[0], pixel[1], 255)
                                                         : qRgb(grey, grey, grey));
        }
    }
    return result;
}

} // namespace autocuts
