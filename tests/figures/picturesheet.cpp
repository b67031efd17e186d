#include "figures/picturesheet.h"

#include <QFont>
#include <QImageWriter>
#include <QPainter>

#include <algorithm>
#include <array>

namespace autocuts::figures {

namespace {

constexpr int gap = 6, titleHeight = 24, lineHeight = 19, foot = 6; // pixels
constexpr QRgb ground = 0xff1e2023, titleColor = 0xffe4e6e9, textColor = 0xffa3a8af;
constexpr int paletteSize = 256;

QFont fontOf(int pixels, bool bold)
{
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(pixels);
    font.setBold(bold);
    return font;
}

int picturesHeight(const Column &column)
{
    int height = gap;
    for (const QImage &picture : column.pictures)
        height += picture.height() + gap;
    return height;
}

void drawColumn(QPainter &painter, const Column &column, int left, int textTop)
{
    int top = gap;
    for (const QImage &picture : column.pictures) {
        painter.drawImage(left, top, picture);
        top += picture.height() + gap;
    }
    const int width = column.pictures.front().width();
    painter.setFont(fontOf(15, true));
    painter.setPen(QColor(titleColor));
    painter.drawText(QRect(left + gap, textTop, width - gap, titleHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     column.title);
    painter.setFont(fontOf(13, false));
    painter.setPen(QColor(textColor));
    for (int i = 0; i < column.lines.size(); ++i)
        painter.drawText(QRect(left + gap, textTop + titleHeight + i * lineHeight, width - gap, lineHeight),
                         Qt::AlignLeft | Qt::AlignVCenter, column.lines[i]);
}

//! Colours of a picture with how often they occur.
struct ColorCount
{
    std::array<int, 3> color;
    qint64 count;
};

//! A part of the colours, which is split where it is widest.
struct ColorBox
{
    int begin, end; // in the list of colours
    int axis;       // the widest one
    double spread;  // sum of the squared distances to the mean along it
};

ColorBox boxOf(const std::vector<ColorCount> &colors, int begin, int end)
{
    ColorBox box{begin, end, 0, -1};
    for (int axis = 0; axis < 3; ++axis) {
        double sum = 0, squares = 0, count = 0;
        for (int i = begin; i < end; ++i) {
            const double value = colors[i].color[axis], weight = double(colors[i].count);
            sum += weight * value;
            squares += weight * value * value;
            count += weight;
        }
        const double spread = squares - sum * sum / count;
        if (spread > box.spread) {
            box.spread = spread;
            box.axis = axis;
        }
    }
    return box;
}

std::vector<ColorCount> countColors(const QImage &picture)
{
    QHash<QRgb, qint64> counts;
    for (int y = 0; y < picture.height(); ++y) {
        const auto *line = reinterpret_cast<const QRgb *>(picture.constScanLine(y));
        for (int x = 0; x < picture.width(); ++x)
            ++counts[line[x]];
    }
    std::vector<ColorCount> colors;
    for (auto it = counts.cbegin(); it != counts.cend(); ++it)
        colors.push_back({{qRed(it.key()), qGreen(it.key()), qBlue(it.key())}, it.value()});
    // A hash has no order of its own: the palette must not depend on it.
    std::sort(colors.begin(), colors.end(),
              [](const ColorCount &a, const ColorCount &b) { return a.color < b.color; });
    return colors;
}

//! Colours by splitting the box with the greatest spread at its mean, again and again.
QList<QRgb> paletteOf(const QImage &picture)
{
    std::vector<ColorCount> colors = countColors(picture);
    std::vector<ColorBox> boxes{boxOf(colors, 0, static_cast<int>(colors.size()))};
    while (std::ssize(boxes) < paletteSize) {
        const auto widest = std::max_element(
            boxes.begin(), boxes.end(), [](const auto &a, const auto &b) { return a.spread < b.spread; });
        const ColorBox box = *widest;
        if (box.spread <= 0)
            break;
        double sum = 0, count = 0;
        for (int i = box.begin; i < box.end; ++i) {
            sum += double(colors[i].count) * colors[i].color[box.axis];
            count += double(colors[i].count);
        }
        const double mean = sum / count;
        const auto middle = std::partition(colors.begin() + box.begin, colors.begin() + box.end,
                                           [&](const ColorCount &c) { return c.color[box.axis] <= mean; });
        const int split = static_cast<int>(middle - colors.begin());
        *widest = boxOf(colors, box.begin, split);
        boxes.push_back(boxOf(colors, split, box.end));
    }
    QList<QRgb> palette;
    for (const ColorBox &box : boxes) {
        std::array<double, 3> sum{};
        double count = 0;
        for (int i = box.begin; i < box.end; ++i) {
            for (int axis = 0; axis < 3; ++axis)
                sum[axis] += double(colors[i].count) * colors[i].color[axis];
            count += double(colors[i].count);
        }
        palette << qRgb(static_cast<int>(sum[0] / count + 0.5), static_cast<int>(sum[1] / count + 0.5),
                        static_cast<int>(sum[2] / count + 0.5));
    }
    return palette;
}

} // namespace

QImage sheetOf(const std::vector<Column> &columns)
{
    int width = gap, textTop = 0, lines = 0;
    for (const Column &column : columns) {
        width += column.pictures.front().width() + gap;
        textTop = std::max(textTop, picturesHeight(column));
        lines = std::max(lines, static_cast<int>(column.lines.size()));
    }
    QImage sheet(width, textTop + titleHeight + lines * lineHeight + foot, QImage::Format_RGB32);
    sheet.fill(ground);
    QPainter painter(&sheet);
    painter.setRenderHint(QPainter::TextAntialiasing);
    int left = gap;
    for (const Column &column : columns) {
        drawColumn(painter, column, left, textTop);
        left += column.pictures.front().width() + gap;
    }
    return sheet;
}

bool saveSmall(const QImage &picture, const QString &path)
{
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB32);
    QImageWriter writer(path, "png");
    writer.setCompression(100);
    return writer.write(rgb.convertToFormat(QImage::Format_Indexed8, paletteOf(rgb), Qt::ThresholdDither));
}

} // namespace autocuts::figures
