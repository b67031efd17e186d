#include "model/pictures/hdrpictures.h"

#include "model/pictures/picturesize.h"

#include <QCoreApplication>
#include <QList>

#include <array>
#include <cmath>
#include <optional>

namespace autocuts {

namespace {

struct HdrTexts
{
    Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

using Rgbe = std::array<uchar, 4>;

//! The bytes from the front.
class Bytes
{
public:
    explicit Bytes(QByteArrayView bytes) : mRest(bytes) {}

    qsizetype left() const { return mRest.size(); }
    //! The next line without its end; nothing at the end of the bytes.
    std::optional<QByteArrayView> line()
    {
        const qsizetype end = mRest.indexOf('\n');
        if (end < 0)
            return std::nullopt;
        const QByteArrayView line = mRest.first(end);
        mRest = mRest.sliced(end + 1);
        return line.trimmed();
    }
    bool take(Rgbe &pixel)
    {
        if (mRest.size() < 4)
            return false;
        for (std::size_t k = 0; k < 4; ++k)
            pixel[k] = uchar(mRest[qsizetype(k)]);
        mRest = mRest.sliced(4);
        return true;
    }
    bool take(uchar &byte)
    {
        if (mRest.isEmpty())
            return false;
        byte = uchar(mRest[0]);
        mRest = mRest.sliced(1);
        return true;
    }

private:
    QByteArrayView mRest;
};

struct Size
{
    qint64 width = 0, height = 0;
    bool fromBelow = false, fromRight = false;
};

//! Of a line such as "-Y 512 +X 1024".
std::optional<Size> sizeOf(QByteArrayView line)
{
    const QList<QByteArray> words = line.toByteArray().simplified().split(' ');
    if (words.size() != 4 || words[0].size() != 2 || words[2].size() != 2 || words[0][1] != 'Y' ||
        words[2][1] != 'X')
        return std::nullopt;
    bool ok[2] = {};
    const Size size{words[3].toInt(&ok[1]), words[1].toInt(&ok[0]), words[0][0] == '+', words[2][0] == '-'};
    return ok[0] && ok[1] ? std::optional(size) : std::nullopt;
}

//! A line of the newer kind: the four bytes of all pixels one after another, each in runs.
bool readSplitLine(Bytes &bytes, std::vector<Rgbe> &line)
{
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t x = 0; x < line.size();) {
            uchar count = 0, value = 0;
            if (!bytes.take(count))
                return false;
            const bool run = count > 128;
            const std::size_t length = run ? count - 128U : count;
            if (length == 0 || length > line.size() - x || (run && !bytes.take(value)))
                return false;
            for (const std::size_t end = x + length; x < end; ++x) {
                if (!run && !bytes.take(value))
                    return false;
                line[x][k] = value;
            }
        }
    }
    return true;
}

//! A line of plain pixels, or of the older kind of runs: 1 1 1 N repeats the pixel before. Some such pixels
//! one after another are the digits of a longer run, the lowest first.
bool readPlainLine(Bytes &bytes, Rgbe pixel, std::vector<Rgbe> &line)
{
    int shift = 0;
    for (std::size_t x = 0; x < line.size();) {
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1 && x > 0 && shift < 24) {
            const std::size_t length = std::size_t(pixel[3]) << shift;
            if (length > line.size() - x)
                return false;
            std::fill_n(line.begin() + std::ptrdiff_t(x), length, line[x - 1]);
            x += length;
            shift += 8;
        } else {
            line[x++] = pixel;
            shift = 0;
        }
        if (x < line.size() && !bytes.take(pixel))
            return false;
    }
    return true;
}

bool readLine(Bytes &bytes, std::vector<Rgbe> &line)
{
    Rgbe first;
    if (!bytes.take(first))
        return false;
    const std::size_t width = line.size();
    const bool split = width >= 8 && width < 32768 && first[0] == 2 && first[1] == 2 &&
                       std::size_t(first[2]) * 256 + first[3] == width;
    return split ? readSplitLine(bytes, line) : readPlainLine(bytes, first, line);
}

} // namespace

bool isHdr(QByteArrayView bytes)
{
    return bytes.startsWith("#?RADIANCE") || bytes.startsWith("#?RGBE");
}

Result<Picture> readHdr(QByteArrayView content, const QString &path)
{
    Bytes bytes(content);
    std::optional<QByteArrayView> line = bytes.line();
    while (line && !line->isEmpty()) {
        if (line->startsWith("FORMAT=") && *line != QByteArrayView("FORMAT=32-bit_rle_rgbe"))
            return brokenPicture(path, HdrTexts::tr("its colours are not RGBE"));
        line = bytes.line();
    }
    line = bytes.line();
    const std::optional<Size> size = line ? sizeOf(*line) : std::nullopt;
    if (!size)
        return brokenPicture(path);
    if (const auto checked = checkPictureSize(size->width, size->height, content.size(), path); !checked)
        return checked.error();
    if (bytes.left() < 4 * size->height)
        return brokenPicture(path, HdrTexts::tr("it is too short"));
    Picture picture(int(size->width), int(size->height), 3);
    std::vector<Rgbe> pixels(std::size_t(size->width));
    for (int y = 0; y < picture.height; ++y) {
        if (!readLine(bytes, pixels))
            return brokenPicture(path, HdrTexts::tr("line %1 is damaged").arg(y + 1));
        for (int x = 0; x < picture.width; ++x) {
            const Rgbe &pixel = pixels[std::size_t(x)];
            const float unit = pixel[3] == 0 ? 0.0F : std::ldexp(1.0F, int(pixel[3]) - 136);
            const auto out = picture.at(size->fromRight ? picture.width - 1 - x : x,
                                        size->fromBelow ? picture.height - 1 - y : y);
            for (std::size_t k = 0; k < 3; ++k)
                out[k] = float(pixel[k]) * unit;
        }
    }
    return picture;
}

} // namespace autocuts
