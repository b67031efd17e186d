#include "model/pictures/exrpictures.h"

#include "model/pictures/picturesize.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <stdexcept>

namespace autocuts {

namespace {

struct ExrTexts
{
    Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

//! The library keeps up to 256 lines of all channels; more bytes of them are refused. Chosen by hand.
constexpr qint64 maxLineBytes = 8 << 20;

class BytesIn final : public Imf::IStream
{
public:
    explicit BytesIn(QByteArrayView bytes) : IStream("picture"), mBytes(bytes) {}

    bool read(char out[], int count) override
    {
        if (count < 0 || mPlace > quint64(mBytes.size()) || quint64(count) > quint64(mBytes.size()) - mPlace)
            throw std::runtime_error("the file ends too early");
        std::memcpy(out, mBytes.data() + mPlace, std::size_t(count));
        mPlace += quint64(count);
        return mPlace < quint64(mBytes.size());
    }
    std::uint64_t tellg() override { return mPlace; }
    void seekg(std::uint64_t place) override { mPlace = place; }

private:
    QByteArrayView mBytes;
    quint64 mPlace = 0;
};

class BytesOut final : public Imf::OStream
{
public:
    BytesOut() : OStream("picture") {}

    void write(const char bytes[], int count) override
    {
        const auto end = qsizetype(mPlace) + count;
        if (mBytes.size() < end)
            mBytes.resize(end);
        std::memcpy(mBytes.data() + mPlace, bytes, std::size_t(count));
        mPlace += quint64(count);
    }
    std::uint64_t tellp() override { return mPlace; }
    void seekp(std::uint64_t place) override { mPlace = place; }
    QByteArray take() { return std::move(mBytes); }

private:
    QByteArray mBytes;
    quint64 mPlace = 0;
};

//! Names of the channels that are read as red, green, blue and alpha; empty: none.
struct Channels
{
    std::array<std::string, 4> names;
    bool grey = false; //!< the first name is that of a grey

    bool hasColor() const { return !names[0].empty() || !names[1].empty() || !names[2].empty(); }
    bool hasAlpha() const { return !names[3].empty(); }
    int count() const { return hasAlpha() ? 4 : grey ? 1 : 3; }
};

Channels channelsOf(const Imf::Header &header)
{
    std::map<std::string, Channels> layers; // that without a name comes first
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            continue;
        const std::string name = it.name();
        const std::size_t dot = name.rfind('.');
        const bool layered = dot != std::string::npos;
        Channels &layer = layers[layered ? name.substr(0, dot) : std::string()];
        const QString last = QString::fromStdString(layered ? name.substr(dot + 1) : name).toUpper();
        if (const qsizetype place = QStringLiteral("RGBA").indexOf(last); last.size() == 1 && place >= 0)
            layer.names[std::size_t(place)] = name;
        else if (last == QLatin1StringView("Y") && layer.names[0].empty()) {
            layer.names[0] = name;
            layer.grey = true;
        }
    }
    for (auto &[prefix, layer] : layers) {
        if (!layer.hasColor())
            continue;
        if (!layer.names[0].empty() && layer.names[1].empty() && layer.names[2].empty())
            layer.grey = true;
        else
            layer.grey = false;
        return layer;
    }
    Channels first;
    first.grey = true;
    if (header.channels().begin() != header.channels().end())
        first.names[0] = header.channels().begin().name();
    return first;
}

//! The picture of the data window; its size was checked.
Picture readWindow(Imf::InputPart &part, const Channels &channels, const Imath::Box2i &window)
{
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    Picture picture(width, height, channels.count());
    const std::size_t pixel = sizeof(float) * std::size_t(picture.channels), row = pixel * std::size_t(width);
    Imf::FrameBuffer buffer;
    for (std::size_t k = 0; k < 4; ++k) {
        const bool wanted =
            channels.grey ? k == 0 || (k == 3 && channels.hasAlpha()) : k < std::size_t(picture.channels);
        if (!wanted)
            continue;
        char *first = reinterpret_cast<char *>(picture.values.data() + k);
        const std::string name =
            channels.names[k].empty() ? "no such channel " + std::to_string(k) : channels.names[k];
        buffer.insert(name,
                      Imf::Slice::Make(Imf::FLOAT, first, window, pixel, row, 1, 1, k == 3 ? 1.0 : 0.0));
    }
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    if (channels.grey && picture.channels == 4) {
        for (std::size_t i = 0; i < picture.values.size(); i += 4)
            picture.values[i + 1] = picture.values[i + 2] = picture.values[i];
    }
    return picture;
}

Picture inDisplayWindow(Picture data, const Imath::Box2i &window, const Imath::Box2i &display)
{
    if (window == display)
        return data;
    Picture picture(display.max.x - display.min.x + 1, display.max.y - display.min.y + 1, data.channels);
    const int top = std::max(window.min.y, display.min.y), bottom = std::min(window.max.y, display.max.y);
    const int left = std::max(window.min.x, display.min.x), right = std::min(window.max.x, display.max.x);
    for (int y = top; y <= bottom && left <= right; ++y) {
        const auto from = data.at(left - window.min.x, y - window.min.y);
        std::copy_n(from.data(), std::size_t(right - left + 1) * std::size_t(data.channels),
                    picture.at(left - display.min.x, y - display.min.y).data());
    }
    return picture;
}

qint64 sideOf(int first, int last)
{
    return qint64(last) - first + 1;
}

Result<Picture> readFirstPart(QByteArrayView bytes, const QString &path)
{
    BytesIn stream(bytes);
    Imf::MultiPartInputFile file(stream, 0);
    const Imf::Header &header = file.header(0);
    if (header.hasType() && !Imf::isImage(header.type()))
        return brokenPicture(path, ExrTexts::tr("it has several depths at a pixel"));
    const Imath::Box2i window = header.dataWindow(), display = header.displayWindow();
    for (const Imath::Box2i &box : {window, display}) {
        const auto size =
            checkPictureSize(sideOf(box.min.x, box.max.x), sideOf(box.min.y, box.max.y), bytes.size(), path);
        if (!size)
            return size.error();
    }
    qint64 lineBytes = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        lineBytes += 4 * sideOf(window.min.x, window.max.x);
    if (lineBytes > maxLineBytes)
        return brokenPicture(path, ExrTexts::tr("it has too many channels"));
    const Channels channels = channelsOf(header);
    if (channels.names[0].empty() && !channels.hasColor())
        return brokenPicture(path, ExrTexts::tr("it has no channels"));
    Imf::InputPart part(file, 0);
    return inDisplayWindow(readWindow(part, channels, window), window, display);
}

} // namespace

bool isExr(QByteArrayView bytes)
{
    return bytes.startsWith(QByteArrayView("\x76\x2f\x31\x01", 4));
}

Result<Picture> readExr(QByteArrayView bytes, const QString &path)
{
    // Also tables that the library makes while it reads the header are as large as these say.
    static const bool limited = [] {
        Imf::Header::setMaxImageSize(maxPictureSide, maxPictureSide);
        Imf::Header::setMaxTileSize(maxPictureSide, maxPictureSide);
        return true;
    }();
    Q_UNUSED(limited)
    try {
        return readFirstPart(bytes, path);
    } catch (const std::exception &problem) {
        return brokenPicture(path, QString::fromUtf8(problem.what()).simplified().left(200));
    } catch (...) {
        return brokenPicture(path);
    }
}

Result<QByteArray> exrBytes(const Picture &picture, bool half, const QString &path)
{
    constexpr std::array<const char *, 4> colors{"R", "G", "B", "A"};
    const auto name = [&](int k) { return picture.channels == 1 ? "Y" : colors[std::size_t(k)]; };
    const Imf::PixelType type = half ? Imf::HALF : Imf::FLOAT;
    try {
        Imf::Header header(picture.width, picture.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        for (int k = 0; k < picture.channels; ++k)
            header.channels().insert(name(k), Imf::Channel(type));
        const auto count = std::size_t(picture.channels);
        std::vector<Imath::half> halves;
        if (half)
            halves.assign(picture.values.begin(), picture.values.end());
        char *first = half ? reinterpret_cast<char *>(halves.data())
                           : reinterpret_cast<char *>(const_cast<float *>(picture.values.data()));
        const std::size_t number = half ? sizeof(Imath::half) : sizeof(float);
        Imf::FrameBuffer buffer;
        for (int k = 0; k < picture.channels; ++k)
            buffer.insert(name(k), Imf::Slice(type, first + std::size_t(k) * number, count * number,
                                              count * number * std::size_t(picture.width)));
        BytesOut stream;
        {
            Imf::OutputFile file(stream, header, 0);
            file.setFrameBuffer(buffer);
            file.writePixels(picture.height);
        }
        return stream.take();
    } catch (const std::exception &problem) {
        return Error{
            ExrTexts::tr("the picture cannot be written (%1)").arg(QString::fromUtf8(problem.what())),
            path,
            0,
            {}};
    }
}

} // namespace autocuts
