#include "model/pictures/picturefiles.h"

#include "model/pictures/exrpictures.h"
#include "model/pictures/hdrpictures.h"
#include "model/pictures/picturesize.h"
#include "model/pictures/tgapictures.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QImageReader>
#include <QImageWriter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

struct PictureTexts
{
    Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

//! Four float numbers a pixel of the largest picture.
constexpr qint64 maxFileBytes = 16 * maxPicturePixels;

bool isFloat(QImage::Format format)
{
    switch (format) {
    case QImage::Format_RGBX16FPx4:
    case QImage::Format_RGBA16FPx4:
    case QImage::Format_RGBA16FPx4_Premultiplied:
    case QImage::Format_RGBX32FPx4:
    case QImage::Format_RGBA32FPx4:
    case QImage::Format_RGBA32FPx4_Premultiplied:
        return true;
    default:
        return false;
    }
}

bool isGrey(const QImage &image)
{
    switch (image.format()) {
    case QImage::Format_Grayscale8:
    case QImage::Format_Grayscale16:
        return true;
    case QImage::Format_Mono:
    case QImage::Format_MonoLSB:
    case QImage::Format_Indexed8: {
        const QList<QRgb> colors = image.colorTable();
        return std::all_of(colors.begin(), colors.end(),
                           [](QRgb color) { return qIsGray(color) && qAlpha(color) == 255; });
    }
    default:
        return false;
    }
}

//! \param pixels as many numbers for each pixel as `stored`, of which the picture takes the first ones
template <typename Number>
void takeRow(const uchar *pixels, int stored, float scale, int y, Picture &picture)
{
    const auto *numbers = reinterpret_cast<const Number *>(pixels);
    for (int x = 0; x < picture.width; ++x, numbers += stored) {
        const auto out = picture.at(x, y);
        for (std::size_t k = 0; k < out.size(); ++k)
            out[k] = float(numbers[k]) * scale;
    }
}

DecodedPicture fromImage(QImage image)
{
    const bool grey = isGrey(image), floats = isFloat(image.format());
    const bool deep = image.format() == QImage::Format_Grayscale16 || image.depth() == 64;
    const int channels = grey ? 1 : image.hasAlphaChannel() ? 4 : 3;
    image.convertTo(floats         ? QImage::Format_RGBA32FPx4
                    : grey && deep ? QImage::Format_Grayscale16
                    : grey         ? QImage::Format_Grayscale8
                    : deep         ? QImage::Format_RGBA64
                                   : QImage::Format_RGBA8888);
    if (image.isNull())
        throw std::bad_alloc();
    DecodedPicture decoded{Picture(image.width(), image.height(), channels), floats ? PictureDepth::Float
                                                                             : deep ? PictureDepth::Sixteen
                                                                                    : PictureDepth::Eight};
    for (int y = 0; y < image.height(); ++y) {
        const uchar *row = image.constScanLine(y);
        if (floats)
            takeRow<float>(row, 4, 1, y, decoded.picture);
        else if (deep)
            takeRow<quint16>(row, grey ? 1 : 4, 1.0F / 65535, y, decoded.picture);
        else
            takeRow<uchar>(row, grey ? 1 : 4, 1.0F / 255, y, decoded.picture);
    }
    return decoded;
}

Result<DecodedPicture> readByQt(const QByteArray &bytes, const QString &path)
{
    // Qt looks for the end of a TGA file in all files, and prints a warning where they are shorter.
    constexpr qsizetype endOfTga = 26;
    if (bytes.size() < endOfTga)
        return brokenPicture(path);
    allowLargePictures();
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer);
    reader.setDecideFormatFromContent(true);
    reader.setAutoTransform(true);
    if (!reader.canRead())
        return brokenPicture(path);
    const QSize size = reader.size();
    if (!size.isEmpty()) {
        if (const auto checked = checkPictureSize(size.width(), size.height(), bytes.size(), path); !checked)
            return checked.error();
    }
    QImage image = reader.read();
    if (image.isNull())
        return brokenPicture(path, reader.errorString());
    // Not all formats tell their size before.
    if (const auto checked = checkPictureSize(image.width(), image.height(), bytes.size(), path); !checked)
        return checked.error();
    return fromImage(std::move(image));
}

Result<DecodedPicture> decode(const QByteArray &bytes, const QString &path)
{
    const auto decoded = [](Result<Picture> picture, PictureDepth depth) -> Result<DecodedPicture> {
        if (!picture)
            return picture.error();
        return DecodedPicture{std::move(picture).value(), depth};
    };
    if (isExr(bytes))
        return decoded(readExr(bytes, path), PictureDepth::Float);
    if (isHdr(bytes))
        return decoded(readHdr(bytes, path), PictureDepth::Float);
    if (path.endsWith(".tga"_L1, Qt::CaseInsensitive) && isTga(bytes))
        return decoded(readTga(bytes, path), PictureDepth::Eight);
    return readByQt(bytes, path);
}

template <typename Number>
Number wholeNumber(float value)
{
    constexpr auto most = float(std::numeric_limits<Number>::max());
    return std::isnan(value) ? Number(0) : Number(std::lround(std::clamp(value, 0.0F, 1.0F) * most));
}

//! \param stored numbers for each pixel of the image
template <typename Number>
void giveRow(const Picture &picture, int y, int stored, uchar *row)
{
    auto *numbers = reinterpret_cast<Number *>(row);
    for (int x = 0; x < picture.width; ++x) {
        const auto pixel = picture.at(x, y);
        for (int k = 0; k < stored; ++k)
            *numbers++ = k < picture.channels
                             ? wholeNumber<Number>(pixel[std::size_t(picture.channels == 1 ? 0 : k)])
                         : picture.channels == 1 && k < 3 ? wholeNumber<Number>(pixel[0])
                                                          : std::numeric_limits<Number>::max();
    }
}

//! \param withGrey false: a grey picture becomes one of colours
QImage toImage(const Picture &picture, bool deep, bool withGrey)
{
    const bool grey = picture.channels == 1 && withGrey;
    const QImage::Format format = deep ? (grey                    ? QImage::Format_Grayscale16
                                          : picture.channels == 4 ? QImage::Format_RGBA64
                                                                  : QImage::Format_RGBX64)
                                       : (grey                    ? QImage::Format_Grayscale8
                                          : picture.channels == 4 ? QImage::Format_RGBA8888
                                                                  : QImage::Format_RGB888);
    QImage image(picture.width, picture.height, format);
    if (image.isNull())
        throw std::bad_alloc();
    for (int y = 0; y < picture.height; ++y) {
        if (deep)
            giveRow<quint16>(picture, y, grey ? 1 : 4, image.scanLine(y));
        else
            giveRow<uchar>(picture, y, grey ? 1 : picture.channels == 4 ? 4 : 3, image.scanLine(y));
    }
    return image;
}

QByteArray targaOf(const Picture &picture)
{
    QByteArray pixels(qsizetype(picture.values.size()), Qt::Uninitialized);
    std::transform(picture.values.begin(), picture.values.end(), pixels.begin(),
                   [](float value) { return char(wholeNumber<uchar>(value)); });
    return tgaBytes(pixels, picture.width, picture.height, picture.channels);
}

Result<QByteArray> encode(const Picture &picture, const QString &path, const QString &suffix,
                          PictureDepth depth)
{
    if (suffix == "exr"_L1)
        return exrBytes(picture, depth == PictureDepth::Sixteen, path);
    if (suffix == "tga"_L1)
        return targaOf(picture);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, suffix.toLatin1());
    if (suffix.startsWith('j'_L1))
        writer.setQuality(95);
    const bool deep = depth == PictureDepth::Sixteen;
    // Qt writes grey TIFF files with 8 bits only.
    if (!writer.write(toImage(picture, deep, !(deep && suffix.startsWith('t'_L1)))))
        return Error{
            PictureTexts::tr("the picture cannot be written (%1)").arg(writer.errorString()), path, 0, {}};
    return bytes;
}

//! An error where the format of that suffix cannot hold the depth, or is not known.
Result<Done> checkDepth(const QString &suffix, PictureDepth depth, const QString &path)
{
    const bool eight = depth == PictureDepth::Eight, sixteen = depth == PictureDepth::Sixteen;
    if (suffix == "exr"_L1)
        return !eight ? Result<Done>(Done{})
                      : Error{PictureTexts::tr("OpenEXR files have no whole numbers of 8 bits"), path, 0,
                              PictureTexts::tr("Choose 16 bits or float numbers, or a .png file")};
    const bool both = suffix == "png"_L1 || suffix == "tif"_L1 || suffix == "tiff"_L1;
    if (!both && suffix != "jpg"_L1 && suffix != "jpeg"_L1 && suffix != "tga"_L1)
        return Error{PictureTexts::tr("pictures cannot be written in the format \"%1\"").arg(suffix), path, 0,
                     PictureTexts::tr("Choose a file name that ends in .png, .tif, .jpg, .tga or .exr")};
    if (eight || (both && sixteen))
        return Done{};
    return Error{sixteen ? PictureTexts::tr(".%1 files have no numbers of 16 bits").arg(suffix)
                         : PictureTexts::tr(".%1 files have no float numbers").arg(suffix),
                 path, 0,
                 sixteen ? PictureTexts::tr("Choose a .png, .tif or .exr file, or 8 bits")
                         : PictureTexts::tr("Choose an .exr file, or 8 or 16 bits")};
}

Error noMemory(const QString &path)
{
    return {PictureTexts::tr("there is not enough memory for the picture"), path, 0,
            PictureTexts::tr("Close other programs, or scale the picture down")};
}

} // namespace

Result<QByteArray> loadPictureFile(const QString &path)
{
    if (const qint64 size = QFileInfo(path).size(); size > maxFileBytes)
        return Error{
            PictureTexts::tr("the picture has %1 bytes, the limit is %2").arg(size).arg(maxFileBytes), path,
            0, PictureTexts::tr("Scale the picture down to sides of %1 pixels at most").arg(maxPictureSide)};
    return loadFile(path, maxFileBytes);
}

Result<DecodedPicture> decodePicture(const QByteArray &bytes, const QString &path)
{
    try {
        return decode(bytes, path);
    } catch (const std::bad_alloc &) {
        return noMemory(path);
    }
}

Result<DecodedPicture> readDecodedPicture(const QString &path)
{
    const Result<QByteArray> bytes = loadPictureFile(path);
    if (!bytes)
        return bytes.error();
    return decodePicture(bytes.value(), path);
}

Result<Picture> readPicture(const QString &path)
{
    Result<DecodedPicture> decoded = readDecodedPicture(path);
    if (!decoded)
        return decoded.error();
    return std::move(decoded.value().picture);
}

Result<QByteArray> encodePicture(const Picture &picture, const QString &path, PictureDepth depth)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (const auto checked = checkDepth(suffix, depth, path); !checked)
        return checked.error();
    if (picture.isEmpty())
        return Error{PictureTexts::tr("the picture has no pixels"), path, 0, {}};
    try {
        return encode(picture, path, suffix, depth);
    } catch (const std::bad_alloc &) {
        return noMemory(path);
    }
}

Result<Done> addPicture(const Picture &picture, const QString &path, PictureDepth depth, FileSet &files)
{
    const Result<QByteArray> bytes = encodePicture(picture, path, depth);
    return bytes ? files.add(path, bytes.value()) : Result<Done>(bytes.error());
}

Result<Done> writePicture(const Picture &picture, const QString &path, PictureDepth depth)
{
    FileSet files;
    if (Result<Done> added = addPicture(picture, path, depth, files); !added)
        return added;
    return files.putInPlace();
}

Result<PictureDepth> pictureDepth(const QString &suffix, int bits)
{
    const bool floats = suffix == "exr"_L1;
    if (bits == 0)
        bits = floats ? 32 : 8;
    if (floats ? bits < 16 : suffix == "tga"_L1 ? bits != 8 : bits > 16)
        return Error{PictureTexts::tr("%1 files have no numbers of %2 bits").arg(suffix).arg(bits),
                     {},
                     0,
                     PictureTexts::tr("Choose other bits or another format")};
    return bits == 8 ? PictureDepth::Eight : bits == 16 ? PictureDepth::Sixteen : PictureDepth::Float;
}

Result<Done> makePictureFolder(const QString &folder)
{
    if (!QDir().mkpath(folder) || !QFileInfo(folder).isWritable())
        return Error{PictureTexts::tr("the folder for the pictures cannot be written"), folder, 0,
                     PictureTexts::tr("Check its permissions or choose another one")};
    return Done{};
}

QStringList pictureSuffixes()
{
    QStringList suffixes;
    for (const QByteArray &format : QImageReader::supportedImageFormats())
        suffixes << QString::fromLatin1(format).toLower();
    suffixes << u"tga"_s << u"exr"_s << u"hdr"_s;
    suffixes.sort();
    suffixes.removeDuplicates();
    return suffixes;
}

} // namespace autocuts
