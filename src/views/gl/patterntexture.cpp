#include "views/gl/patterntexture.h"

#include <QElapsedTimer>

#include <algorithm>
#include <array>

namespace autocuts {

namespace {

using Texel = std::array<quint8, 4>;

//! A number of three bytes, and one more byte.
Texel texelOf(std::size_t number, int extra)
{
    return {static_cast<quint8>(number & 0xff), static_cast<quint8>(number >> 8 & 0xff),
            static_cast<quint8>(number >> 16 & 0xff), static_cast<quint8>(extra)};
}

//! First a texel for each set: where its entries begin, and its rows of tiles, 0 for a picture that repeats.
//! Then the entries: a picture, and 1 where there is one.
std::vector<Texel> tableOf(const Pictures &pictures, int layers)
{
    std::vector<Texel> table(pictures.sets.size());
    const auto entry = [layers](int picture) {
        return picture >= 0 && picture < layers ? texelOf(static_cast<std::size_t>(picture), 1)
                                                : texelOf(0, 0);
    };
    for (std::size_t s = 0; s < pictures.sets.size(); ++s) {
        const Pictures::Set &set = pictures.sets[s];
        const int rows = set.tiles.empty() ? 0 : set.tiles.rbegin()->first / Pictures::tilesPerRow + 1;
        table[s] = texelOf(table.size(), std::min(rows, 255));
        if (rows == 0)
            table.push_back(entry(set.repeated));
        for (int place = 0; place < Pictures::tilesPerRow * rows; ++place) {
            const auto found = set.tiles.find(place);
            table.push_back(entry(found == set.tiles.end() ? -1 : found->second));
        }
    }
    return table;
}

std::vector<qint64> keysOf(const Pictures &pictures)
{
    std::vector<qint64> keys;
    for (const QImage &image : pictures.images)
        keys.push_back(image.cacheKey());
    return keys;
}

//! Pixels that are uploaded at a time. Chosen by hand.
constexpr int pixelsOfPart = 1 << 18;

} // namespace

const QImage &PatternTexture::Upload::source() const
{
    const auto place = static_cast<std::size_t>(image);
    return level == 0 ? pictures.images[place] : pictures.smaller[place][static_cast<std::size_t>(level - 1)];
}

//! Some rows, from below.
void PatternTexture::Upload::uploadPart()
{
    const QImage &from = source();
    const int rows = std::clamp(pixelsOfPart / from.width(), 1, from.height() - row);
    const std::size_t length = 4 * static_cast<std::size_t>(from.width());
    std::vector<uchar> part(length * static_cast<std::size_t>(rows));
    for (int y = 0; y < rows; ++y)
        std::copy_n(from.constScanLine(from.height() - 1 - row - y), length,
                    part.begin() + static_cast<std::ptrdiff_t>(length) * y);
    texture->setData(0, row, 0, from.width(), rows, 1, level, image, QOpenGLTexture::RGBA,
                     QOpenGLTexture::UInt8, part.data());
    row += rows;
    if (row < from.height())
        return;
    row = 0;
    const std::size_t copies = pictures.smaller.empty() ? 0 : pictures.smaller.front().size();
    if (++level > static_cast<int>(copies)) {
        level = 0;
        ++image;
    }
    if (isComplete() && copies == 0)
        texture->generateMipMaps();
}

void PatternTexture::allocate(Upload &upload)
{
    GLint largest = 1024, mostLayers = 256;
    mGl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    mGl.glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
    Pictures &pictures = upload.pictures;
    if (std::ssize(pictures.images) > mostLayers)
        pictures.images.resize(static_cast<std::size_t>(mostLayers));
    const QSize size = commonSize(pictures.images, largest);
    for (QImage &image : pictures.images) {
        if (image.size() != size)
            pictures.smaller.clear();
        image = readyForUpload(image, size);
    }
    if (pictures.smaller.size() < pictures.images.size())
        pictures.smaller.clear();
    upload.images = static_cast<int>(pictures.images.size());
    QOpenGLTexture &texture =
        *(upload.texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2DArray));
    texture.setAutoMipMapGenerationEnabled(false);
    texture.setFormat(QOpenGLTexture::RGBA8_UNorm);
    texture.setSize(size.width(), size.height());
    texture.setLayers(upload.images);
    texture.setMipLevels(texture.maximumMipLevels());
    texture.allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8);
    texture.setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    texture.setWrapMode(QOpenGLTexture::Repeat);
    texture.setMaximumAnisotropy(8);
}

void PatternTexture::begin(const Pictures &pictures, bool keep)
{
    mNext = std::make_unique<Upload>();
    mNext->pictures = pictures;
    mNext->keys = keysOf(pictures);
    mNext->images = static_cast<int>(pictures.images.size());
    if (!keep || pictures.images.empty())
        mTexture.reset();
}

bool PatternTexture::has(const Pictures &pictures) const
{
    return !mNext && mLayers == pictures.layers && mSets == pictures.sets && mImages == keysOf(pictures);
}

void PatternTexture::goOn(int milliseconds)
{
    QElapsedTimer clock;
    clock.start();
    while (isBusy()) {
        if (mNext->texture)
            mNext->uploadPart();
        else
            allocate(*mNext);
        if (clock.elapsed() >= milliseconds)
            break;
    }
}

bool PatternTexture::show()
{
    if (!mNext || isBusy())
        return false;
    const std::unique_ptr<Upload> shown = std::move(mNext);
    mTexture = std::move(shown->texture);
    mLayers = shown->pictures.layers;
    mImages = shown->keys;
    mSets = shown->pictures.sets;
    if (mTexture) {
        const std::vector<Texel> table = tableOf(shown->pictures, shown->images);
        mTable.fill(std::span<const Texel>(table));
    }
    return true;
}

void PatternTexture::bind(int pictureUnit, int tableUnit)
{
    if (!mTexture)
        return;
    mTable.bind(tableUnit);
    mTexture->bind(static_cast<uint>(pictureUnit));
}

} // namespace autocuts
