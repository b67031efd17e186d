#include "views/gl/picturereading.h"

#include "model/io/texturefiles.h"
#include "model/plain/packingsettings.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QImageReader>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! What all pictures may take together, in pixels of four bytes. Chosen by hand.
constexpr double pixelBudget = 128.0 * (1 << 20);
//! More tiles are left out. Chosen by hand.
constexpr std::size_t maxPictures = 256;

QString text(const char *source)
{
    return QCoreApplication::translate("Pictures", source);
}

//! The picture, no longer than that many pixels; null with a problem.
QImage readPicture(QIODevice &device, int longest, QString &problem)
{
    // Qt's own limit of 128 MB would refuse usual textures; ours are checked before anything is decoded.
    static const bool limited = (QImageReader::setAllocationLimit(1100), true);
    Q_UNUSED(limited)
    if (!device.open(QIODevice::ReadOnly)) {
        problem = text(QT_TRANSLATE_NOOP("Pictures", "it cannot be opened"));
        return {};
    }
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
    QImage image = reader.read();
    if (image.isNull())
        problem = reader.errorString();
    else if (std::max(image.width(), image.height()) > longest)
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
            QByteArray bytes = request.content;
            QBuffer buffer(&bytes);
            set.repeated = take(readPicture(buffer, mLongest, problem));
        }
        for (const TextureTile &file : files) {
            QFile picture(file.path);
            const int image = stopped() ? -1 : take(readPicture(picture, mLongest, problem));
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
    const double room = pixelBudget / static_cast<double>(std::clamp<std::size_t>(count, 1, maxPictures));
    const int longest =
        std::clamp(static_cast<int>(std::exp2(std::floor(std::log2(std::sqrt(room))))), 256, maxPictureSide);
    Reading reading(longest, problems, stop);
    for (std::size_t r = 0; r < requests.size(); ++r)
        reading.add(requests[r], files[r]);
    return reading.result();
}

} // namespace autocuts
