#include "model/pictures/picturesize.h"

#include <QCoreApplication>
#include <QImageReader>

#include <algorithm>
#include <mutex>

namespace autocuts {

namespace {

struct SizeTexts
{
    Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

//! Pixels that a file may have for each of its bytes, where it has many: beyond what a picture of one colour
//! takes. Chosen by hand.
constexpr qint64 pixelsPerByte = 16384;
constexpr qint64 fewPixels = 1024 * 1024;

} // namespace

Result<Done> checkPictureSize(qint64 width, qint64 height, qint64 fileBytes, const QString &path)
{
    if (width <= 0 || height <= 0)
        return Error{SizeTexts::tr("the picture has no pixels"), path, 0,
                     SizeTexts::tr("Save it again in the program that it comes from")};
    if (std::max(width, height) > maxPictureSide || width * height > maxPicturePixels)
        return Error{
            SizeTexts::tr("%1 x %2 pixels are too many").arg(width).arg(height), path, 0,
            SizeTexts::tr("Scale the picture down to sides of %1 pixels at most").arg(maxPictureSide)};
    if (width * height > fewPixels && width * height / pixelsPerByte > fileBytes)
        return brokenPicture(path, SizeTexts::tr("it is too short"));
    return Done{};
}

void allowLargePictures()
{
    // In MB: four numbers of 16 bits a pixel of the largest picture.
    constexpr auto megabytes = static_cast<int>(8 * maxPicturePixels / (1024 * 1024));
    static std::once_flag once;
    std::call_once(once, [] { QImageReader::setAllocationLimit(megabytes + megabytes / 16); });
}

Error brokenPicture(const QString &path, const QString &reason)
{
    return {reason.isEmpty() ? SizeTexts::tr("the picture is damaged, or its format is not known")
                             : SizeTexts::tr("the picture cannot be read (%1)").arg(reason),
            path, 0, SizeTexts::tr("Save it again in the program that it comes from")};
}

} // namespace autocuts
