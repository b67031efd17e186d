#include "model/pictures/pictures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

//! Half as wide and high: the mean of each four pixels. \pre four bytes for each pixel, not multiplied by
//! alpha
QImage halved(const QImage &image)
{
    const int width = std::max(1, image.width() / 2), height = std::max(1, image.height() / 2);
    QImage result(width, height, image.format());
    for (int y = 0; y < height; ++y) {
        const uchar *upper = image.constScanLine(std::min(2 * y, image.height() - 1));
        const uchar *lower = image.constScanLine(std::min(2 * y + 1, image.height() - 1));
        uchar *out = result.scanLine(y);
        for (int x = 0; x < width; ++x) {
            const int left = 4 * std::min(2 * x, image.width() - 1);
            const int right = 4 * std::min(2 * x + 1, image.width() - 1);
            for (int k = 0; k < 4; ++k)
                *out++ = static_cast<uchar>(
                    (upper[left + k] + upper[right + k] + lower[left + k] + lower[right + k] + 2) / 4);
        }
    }
    return result;
}

} // namespace

QSize commonSize(const std::vector<QImage> &images, int largest)
{
    QSize size(1, 1);
    for (const QImage &image : images)
        size = size.expandedTo(image.size());
    const double room = Pictures::pixelBudget / static_cast<double>(std::max<std::size_t>(1, images.size()));
    const double scale = std::min({1.0, double(largest) / std::max(size.width(), size.height()),
                                   std::sqrt(room / (double(size.width()) * size.height()))});
    return scale < 1 ? (QSizeF(size) * scale).toSize().expandedTo({1, 1}) : size;
}

QImage readyForUpload(const QImage &image, const QSize &size)
{
    const QImage fitting =
        image.size() == size ? image : image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    return fitting.convertToFormat(QImage::Format_RGBA8888);
}

Pictures readyForUpload(Pictures pictures, const std::atomic<bool> *stop)
{
    pictures.smaller.clear();
    const QSize size = commonSize(pictures.images, std::numeric_limits<int>::max());
    for (QImage &image : pictures.images) {
        if (stop && *stop)
            break;
        image = readyForUpload(image, size);
        std::vector<QImage> &copies = pictures.smaller.emplace_back();
        for (QImage next = image; next.width() > 1 || next.height() > 1;)
            copies.push_back(next = halved(next));
    }
    return pictures;
}

} // namespace autocuts
