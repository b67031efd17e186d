#include "model/pictures/tgapictures.h"

#include "model/pictures/picturesize.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <optional>

namespace autocuts {

namespace {

struct TgaTexts
{
    Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

constexpr qsizetype headerSize = 18;

enum class Kind { Palette = 1, Color = 2, Grey = 3 };

struct Header
{
    Kind kind = Kind::Color;
    bool runs = false, fromTop = false, fromRight = false;
    int width = 0, height = 0, pixelBytes = 0, alphaBits = 0;
    int paletteFirst = 0, paletteLength = 0, paletteBytes = 0;
    qsizetype paletteAt = 0;

    int colorBytes() const { return kind == Kind::Palette ? paletteBytes : pixelBytes; }
    int channels() const
    {
        return kind == Kind::Grey ? 1 : colorBytes() == 4 && (alphaBits > 0 || kind == Kind::Palette) ? 4 : 3;
    }
    qsizetype pixelsAt() const { return paletteAt + qsizetype(paletteLength) * paletteBytes; }
};

int bytesOf(int bits)
{
    return (bits + 7) / 8;
}

std::optional<Header> headerOf(QByteArrayView bytes)
{
    if (bytes.size() < headerSize)
        return std::nullopt;
    const auto byte = [&](qsizetype i) { return int(uchar(bytes[i])); };
    const auto word = [&](qsizetype i) { return byte(i) + 256 * byte(i + 1); };
    Header header;
    const int kind = byte(2) & 7, bits = byte(16);
    if ((byte(2) & ~11) != 0 || kind < 1 || kind > 3 || byte(1) > 1)
        return std::nullopt;
    header.kind = Kind(kind);
    header.runs = (byte(2) & 8) != 0;
    header.paletteAt = headerSize + byte(0);
    if (byte(1) == 1) {
        header.paletteFirst = word(3);
        header.paletteLength = word(5);
        header.paletteBytes = bytesOf(byte(7));
    }
    header.width = word(12);
    header.height = word(14);
    header.pixelBytes = bytesOf(bits);
    header.alphaBits = byte(17) & 15;
    header.fromTop = (byte(17) & 32) != 0;
    header.fromRight = (byte(17) & 16) != 0;
    const bool small = bits == 8, color = bits == 15 || bits == 16 || bits == 24 || bits == 32;
    const bool palette = header.kind == Kind::Palette;
    const bool fits = palette ? (small || bits == 16) && header.paletteBytes >= 2 && header.paletteBytes <= 4
                      : header.kind == Kind::Grey ? small
                                                  : color;
    return fits && header.width > 0 && header.height > 0 ? std::optional(header) : std::nullopt;
}

//! The numbers of a pixel or of an entry of the palette, blue first in the file.
std::array<float, 4> colorOf(const char *bytes, int count)
{
    const auto byte = [&](int i) { return float(uchar(bytes[i])) / 255.0F; };
    if (count == 1)
        return {byte(0), byte(0), byte(0), 1};
    if (count >= 3)
        return {byte(2), byte(1), byte(0), count == 4 ? byte(3) : 1.0F};
    const unsigned bits = uchar(bytes[0]) + 256U * uchar(bytes[1]);
    const auto five = [&](unsigned shift) { return float((bits >> shift) & 31U) / 31.0F; };
    return {five(10), five(5), five(0), 1};
}

//! Gives one pixel after another, with runs resolved.
class Pixels
{
public:
    Pixels(QByteArrayView bytes, const Header &header)
        : mBytes(bytes), mHeader(header), mPlace(header.pixelsAt())
    {}

    //! Where the next pixel is; null where the bytes end.
    const char *next()
    {
        const qsizetype size = mHeader.pixelBytes;
        if (mHeader.runs && mLeft == 0) {
            if (mPlace >= mBytes.size())
                return nullptr;
            const int packet = uchar(mBytes[mPlace++]);
            mLeft = (packet & 127) + 1;
            mRepeats = packet > 127;
            mPlace += mRepeats ? size : 0;
        }
        if (!mRepeats)
            mPlace += size;
        --mLeft;
        return mPlace <= mBytes.size() ? mBytes.data() + mPlace - size : nullptr;
    }

private:
    QByteArrayView mBytes;
    const Header &mHeader;
    qsizetype mPlace;
    int mLeft = 0;
    bool mRepeats = false;
};

} // namespace

bool isTga(QByteArrayView bytes)
{
    return headerOf(bytes).has_value();
}

Result<Picture> readTga(QByteArrayView bytes, const QString &path)
{
    const std::optional<Header> header = headerOf(bytes);
    if (!header)
        return brokenPicture(path);
    if (const auto size = checkPictureSize(header->width, header->height, bytes.size(), path); !size)
        return size.error();
    const Error tooShort = brokenPicture(path, TgaTexts::tr("it is too short"));
    if (bytes.size() < header->pixelsAt())
        return tooShort;
    Picture picture(header->width, header->height, header->channels());
    Pixels pixels(bytes, *header);
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const char *pixel = pixels.next();
            if (!pixel)
                return tooShort;
            if (header->kind == Kind::Palette) {
                const int number = uchar(pixel[0]) + (header->pixelBytes == 2 ? 256 * uchar(pixel[1]) : 0);
                const int entry = number - header->paletteFirst;
                if (entry < 0 || entry >= header->paletteLength)
                    return brokenPicture(path, TgaTexts::tr("a colour is not in its palette"));
                pixel = bytes.data() + header->paletteAt + qsizetype(entry) * header->paletteBytes;
            }
            const std::array<float, 4> color = colorOf(pixel, header->colorBytes());
            const auto out = picture.at(header->fromRight ? picture.width - 1 - column : column,
                                        header->fromTop ? row : picture.height - 1 - row);
            std::copy_n(color.begin(), out.size(), out.begin());
        }
    }
    return picture;
}

QByteArray tgaBytes(QByteArrayView pixels, int width, int height, int channels)
{
    QByteArray bytes(headerSize, '\0');
    bytes[2] = char(channels == 1 ? Kind::Grey : Kind::Color);
    bytes[12] = char(width & 255);
    bytes[13] = char(width >> 8);
    bytes[14] = char(height & 255);
    bytes[15] = char(height >> 8);
    bytes[16] = char(8 * channels);
    bytes[17] = char(32 + (channels == 4 ? 8 : 0)); // from the top
    bytes.reserve(headerSize + pixels.size());
    for (qsizetype i = 0; i + channels <= pixels.size(); i += channels) {
        if (channels == 1)
            bytes.append(pixels[i]);
        else
            bytes.append(pixels[i + 2]).append(pixels[i + 1]).append(pixels[i]);
        if (channels == 4)
            bytes.append(pixels[i + 3]);
    }
    return bytes;
}

} // namespace autocuts
