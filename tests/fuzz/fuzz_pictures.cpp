// Fuzzes the readers of OpenEXR, Radiance HDR and TGA pictures: any bytes are refused, or give a picture
// whose size fits; small ones are written as OpenEXR and come back the same.
#include "fuzz/fuzzing.h"
#include "model/pictures/exrpictures.h"
#include "model/pictures/hdrpictures.h"
#include "model/pictures/picturesize.h"
#include "model/pictures/tgapictures.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <QFile>
#include <QTemporaryDir>

#include <cstdint>
#include <cstring>

using namespace autocuts;
using fuzz::require;

namespace {

constexpr std::size_t mostAgain = 4096; // numbers

QByteArray hdr(const QByteArray &pixels)
{
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n" + pixels;
}

void writeHdrSeeds()
{
    QByteArray plain, split;
    for (int i = 0; i < 16; ++i)
        plain += QByteArray("\x40\x80\xc0\x81", 4);
    for (int line = 0; line < 2; ++line) {
        split += QByteArray("\x02\x02\x00\x08", 4);
        for (int k = 0; k < 4; ++k)
            split += QByteArray("\x86\x40\x02\x10\x20", 5); // a run of 6 and 2 plain ones
    }
    fuzz::writeSeed(QStringLiteral("plain.hdr"), hdr(plain));
    fuzz::writeSeed(QStringLiteral("split.hdr"), hdr(split));
    fuzz::writeSeed(QStringLiteral("old.hdr"), hdr(QByteArray("\x40\x80\xc0\x81\x01\x01\x01\x0f", 8)));
}

//! Lines and tiles in all compressions.
void writeExrSeeds()
{
    constexpr int width = 19, height = 18;
    std::vector<float> values(std::size_t(3) * width * height);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = float(i % 23) / 7;
    Imf::FrameBuffer buffer;
    for (int k = 0; k < 3; ++k)
        buffer.insert(std::string(1, "RGB"[k]),
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(values.data() + k), 12, 12 * width));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("seed.exr"));
    for (int c = 0; c < Imf::NUM_COMPRESSION_METHODS; ++c) {
        for (const bool tiled : {false, true}) {
            Imf::Header header(width, height);
            header.compression() = static_cast<Imf::Compression>(c);
            for (int k = 0; k < 3; ++k)
                header.channels().insert(std::string(1, "RGB"[k]), Imf::Channel(Imf::FLOAT));
            if (tiled) {
                header.setTileDescription(Imf::TileDescription(8, 8, Imf::MIPMAP_LEVELS));
                Imf::TiledOutputFile file(path.toUtf8().constData(), header, 0);
                file.setFrameBuffer(buffer);
                file.writeTiles(0, file.numXTiles(0) - 1, 0, file.numYTiles(0) - 1, 0);
            } else {
                Imf::OutputFile file(path.toUtf8().constData(), header, 0);
                file.setFrameBuffer(buffer);
                file.writePixels(height);
            }
            QFile file(path);
            require(file.open(QIODevice::ReadOnly), "a seed cannot be read");
            fuzz::writeSeed(
                QStringLiteral("%1%2.exr").arg(QLatin1StringView(tiled ? "tiles" : "lines")).arg(c),
                file.readAll());
        }
    }
}

void writeTgaSeeds()
{
    const QByteArray pixels(48, '\x55');
    for (const int channels : {1, 3, 4})
        fuzz::writeSeed(QStringLiteral("plain%1.tga").arg(channels),
                        tgaBytes(QByteArrayView(pixels).first(12 * channels), 4, 3, channels));
    QByteArray runs = tgaBytes(QByteArrayView(pixels).first(36), 4, 3, 3).first(18);
    runs[2] = 10;
    fuzz::writeSeed(QStringLiteral("runs.tga"), runs + "\x8b" + "abc");
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    if (qEnvironmentVariableIsSet("AUTOCUTS_FUZZ_SEEDS")) {
        writeHdrSeeds();
        writeExrSeeds();
        writeTgaSeeds();
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    const QString path = QStringLiteral("fuzz");
    const Result<Picture> picture = isExr(bytes)   ? readExr(bytes, path)
                                    : isHdr(bytes) ? readHdr(bytes, path)
                                    : isTga(bytes) ? readTga(bytes, path)
                                                   : brokenPicture(path);
    if (!picture)
        return 0;
    require(picture->width > 0 && picture->height > 0 && picture->width <= maxPictureSide &&
                picture->height <= maxPictureSide,
            "the size is wrong");
    require(picture->channels == 1 || picture->channels == 3 || picture->channels == 4,
            "the channels are wrong");
    require(picture->values.size() ==
                std::size_t(picture->width) * std::size_t(picture->height) * std::size_t(picture->channels),
            "the number of values is wrong");
    if (picture->values.size() > mostAgain)
        return 0;
    const Result<QByteArray> written = exrBytes(picture.value(), false, path);
    require(written.ok(), "the picture cannot be written");
    const Result<Picture> again = readExr(written.value(), path);
    require(again.ok() && again->channels == picture->channels &&
                again->values.size() == picture->values.size() &&
                std::memcmp(again->values.data(), picture->values.data(), 4 * picture->values.size()) == 0,
            "the written picture differs");
    return 0;
}
