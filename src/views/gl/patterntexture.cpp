#include "views/gl/patterntexture.h"

#include <algorithm>
#include <array>
#include <cmath>

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

//! The common size of all layers.
QSize sizeOf(const std::vector<QImage> &images, int layers, int largest)
{
    QSize size(1, 1);
    for (const QImage &image : images)
        size = size.expandedTo(image.size());
    const double room = Pictures::pixelBudget / layers;
    const double scale = std::min({1.0, double(largest) / std::max(size.width(), size.height()),
                                   std::sqrt(room / (double(size.width()) * size.height()))});
    return scale < 1 ? (QSizeF(size) * scale).toSize().expandedTo({1, 1}) : size;
}

} // namespace

void PatternTexture::setPictures(const Pictures &pictures)
{
    mTexture.reset();
    mLayers = pictures.layers;
    if (pictures.images.empty())
        return;
    GLint largest = 1024, mostLayers = 256;
    mGl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    mGl.glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
    const int layers = std::min(static_cast<int>(pictures.images.size()), mostLayers);
    const QSize size = sizeOf(pictures.images, layers, largest);
    mTexture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2DArray);
    mTexture->setFormat(QOpenGLTexture::RGBA8_UNorm);
    mTexture->setSize(size.width(), size.height());
    mTexture->setLayers(layers);
    mTexture->setMipLevels(mTexture->maximumMipLevels());
    mTexture->allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8);
    for (int layer = 0; layer < layers; ++layer) {
        QImage image = pictures.images[static_cast<std::size_t>(layer)];
        if (image.size() != size)
            image = image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        image = image.mirrored().convertToFormat(QImage::Format_RGBA8888);
        mTexture->setData(0, layer, QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, image.constBits());
    }
    mTexture->generateMipMaps();
    mTexture->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    mTexture->setWrapMode(QOpenGLTexture::Repeat);
    mTexture->setMaximumAnisotropy(8);
    const std::vector<Texel> table = tableOf(pictures, layers);
    mTable.fill(std::span<const Texel>(table));
}

void PatternTexture::bind(int pictureUnit, int tableUnit)
{
    if (!mTexture)
        return;
    mTable.bind(tableUnit);
    mTexture->bind(static_cast<uint>(pictureUnit));
}

} // namespace autocuts
