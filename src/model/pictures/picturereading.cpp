#include "model/pictures/picturereading.h"

#include "model/pictures/exrpictures.h"
#include "model/pictures/hdrpictures.h"
#include "model/pictures/picturefiles.h"
#include "model/pictures/picturesize.h"
#include "model/pictures/texturefiles.h"
#include "model/pictures/tgapictures.h"
#include "model/plain/packingsettings.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QImageReader>

#include <algorithm>
#include <cmath>
#include <optional>

namespace autocuts {

namespace {

//! More tiles are left out. Chosen by hand.
constexpr std::size_t maxPictures = 256;

QString text(const char *source)
{
    return QCoreApplication::translate("Pictures", source);
}

//! The image of float numbers.
QImage toImage(const Picture &picture, PictureNumbers numbers)
{
    const bool grey = picture.channels == 1;
    QImage image(picture.width, picture.height, grey ? QImage::Format_Grayscale8 : QImage::Format_RGBA8888);
    for (int y = 0; y < image.height(); ++y) {
        uchar *out = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x) {
            const auto pixel = picture.at(x, y);
            for (int k = 0; k < (grey ? 1 : 4); ++k) {
                float value = k < picture.channels ? pixel[static_cast<std::size_t>(k)] : 1;
                if (numbers == PictureNumbers::Color && k < 3)
                    value = srgbFromLinear(value);
                // NaN becomes 0, too
                *out++ = value > 0 ? static_cast<uchar>(std::lround(std::min(value, 1.0F) * 255)) : uchar(0);
            }
        }
    }
    return image;
}

//! Formats that Qt does not read, or only a part of.
bool isOurs(QIODevice &device, const QString &path)
{
    const QByteArray head = device.peek(32);
    const bool targa = path.endsWith(QStringLiteral(".tga"), Qt::CaseInsensitive);
    return isExr(head) || isHdr(head) || (targa && isTga(head));
}

//! Nothing for formats that Qt reads.
std::optional<QImage> readByOurselves(QIODevice &device, const PictureRequest &request,
                                      PictureNumbers numbers, QString &problem)
{
    if (!isOurs(device, request.path))
        return std::nullopt;
    const Result<DecodedPicture> decoded = decodePicture(device.readAll(), request.path);
    if (!decoded) {
        problem = decoded.error().message;
        return QImage();
    }
    const bool floats = decoded->depth == PictureDepth::Float;
    return toImage(decoded->picture, floats ? numbers : PictureNumbers::Plain);
}

QImage readFrom(QIODevice &device, const PictureRequest &request, int longest, PictureNumbers numbers,
                QString &problem)
{
    allowLargePictures();
    if (!device.open(QIODevice::ReadOnly)) {
        problem = text(QT_TRANSLATE_NOOP("Pictures", "it cannot be opened"));
        return {};
    }
    QImage image;
    if (const auto own = readByOurselves(device, request, numbers, problem)) {
        image = *own;
    } else {
        QImageReader reader(&device);
        reader.setDecideFormatFromContent(true);
        reader.setAutoTransform(true);
        const QSize size = reader.size();
        if (!size.isEmpty() && (std::max(size.width(), size.height()) > maxPictureSide ||
                                qint64(size.width()) * size.height() > maxPicturePixels)) {
            problem = text(QT_TRANSLATE_NOOP("Pictures", "%1 x %2 pixels are too many"))
                          .arg(size.width())
                          .arg(size.height());
            return {};
        }
        if (std::max(size.width(), size.height()) > longest)
            reader.setScaledSize(size.scaled(longest, longest, Qt::KeepAspectRatio).expandedTo({1, 1}));
        image = reader.read();
        if (image.isNull())
            problem = reader.errorString();
    }
    if (std::max(image.width(), image.height()) > longest)
        image = image.scaled(longest, longest, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    return image;
}

//! Reads the pictures of one texture after another.
class Reading
{
public:
    Reading(int longest, QStringList &problems, const std::atomic<bool> *stop)
        : mLongest(longest), mProblems(problems), mStop(stop)
    {}

    void add(const PictureRequest &request, const std::vector<TextureTile> &files)
    {
        Pictures::Set &set = mPictures.sets.emplace_back();
        QString problem;
        if (!request.content.isEmpty()) {
            set.repeated = take(readImage(request, mLongest, PictureNumbers::Color, problem));
        }
        for (const TextureTile &file : files) {
            const PictureRequest one{file.path, {}, {}};
            const int image = stopped() ? -1 : take(readImage(one, mLongest, PictureNumbers::Color, problem));
            if (file.tile == 0)
                set.repeated = image;
            else if (image >= 0)
                set.tiles[file.tile - PackingSettings::firstTile] = image;
        }
        if (files.empty() && request.content.isEmpty())
            problem = text(QT_TRANSLATE_NOOP("Pictures", "not found"));
        if (!problem.isEmpty() && !stopped())
            mProblems << QStringLiteral("%1 (%2)").arg(request.name, problem);
    }

    Pictures result() { return std::move(mPictures); }

private:
    bool stopped() const { return mStop && *mStop; }
    int take(QImage image)
    {
        if (image.isNull() || mPictures.images.size() >= maxPictures)
            return -1;
        mPictures.images.push_back(std::move(image));
        return static_cast<int>(mPictures.images.size()) - 1;
    }

    int mLongest;
    QStringList &mProblems;
    const std::atomic<bool> *mStop;
    Pictures mPictures;
};

} // namespace

QImage readImage(const PictureRequest &request, int longest, PictureNumbers numbers, QString &problem)
{
    if (request.content.isEmpty()) {
        QFile file(request.path);
        return readFrom(file, request, longest, numbers, problem);
    }
    QByteArray bytes = request.content;
    QBuffer buffer(&bytes);
    return readFrom(buffer, request, longest, numbers, problem);
}

QString pictureProblem(const QString &path)
{
    QFile file(path);
    if (file.open(QIODevice::ReadOnly) && isOurs(file, path))
        return {};
    QImageReader reader(path);
    return reader.canRead() ? QString() : reader.errorString();
}

int longestSide(std::size_t images)
{
    const double room =
        Pictures::pixelBudget / static_cast<double>(std::clamp<std::size_t>(images, 1, maxPictures));
    return std::clamp(static_cast<int>(std::exp2(std::floor(std::log2(std::sqrt(room))))), 256,
                      maxPictureSide);
}

Pictures readPictures(const std::vector<PictureRequest> &requests, QStringList &problems,
                      const std::atomic<bool> *stop)
{
    std::vector<std::vector<TextureTile>> files;
    std::size_t count = 0;
    for (const PictureRequest &request : requests) {
        files.push_back(request.path.isEmpty() || !request.content.isEmpty() ? std::vector<TextureTile>()
                                                                             : textureTiles(request.path));
        count += std::max<std::size_t>(1, files.back().size());
    }
    Reading reading(longestSide(count), problems, stop);
    for (std::size_t r = 0; r < requests.size(); ++r)
        reading.add(requests[r], files[r]);
    return reading.result();
}

} // namespace autocuts
