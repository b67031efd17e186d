#include "views/gl/letteredpattern.h"

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! Small squares along a side of a cell; even, so that the checkerboard goes on across cells.
constexpr int squares = 4;

QColor cellColor(int column, int row, int cells)
{
    // Neighbours differ in hue, and every second row is shifted by half of a step.
    const double hue = (column + 0.5 * (row % 2)) / cells;
    const double lightness = 0.42 + 0.26 * row / std::max(cells - 1, 1);
    return QColor::fromHslF(static_cast<float>(hue - std::floor(hue)), 0.38f, static_cast<float>(lightness));
}

//! Draws letters and arrow twice, so that they have a rim and can be read on any hue.
void drawShape(QPainter &painter, const QPainterPath &shape, double rim)
{
    painter.setPen(QPen(QColor(255, 255, 255, 200), rim, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 22, 26));
    painter.drawPath(shape);
}

QPainterPath arrowUp(const QRectF &box)
{
    const double x = box.center().x(), half = box.width() / 2, stem = box.width() / 6;
    const double neck = box.top() + 0.5 * box.height();
    QPainterPath path;
    path.addPolygon(QPolygonF({{x, box.top()},
                               {x + half, neck},
                               {x + stem, neck},
                               {x + stem, box.bottom()},
                               {x - stem, box.bottom()},
                               {x - stem, neck},
                               {x - half, neck}}));
    path.closeSubpath();
    return path;
}

void drawCell(QPainter &painter, const QRectF &cell, const QColor &color, const QString &name)
{
    const double side = cell.width();
    painter.fillRect(cell, color);
    const double square = side / squares;
    for (int i = 0; i < squares * squares; ++i) {
        if ((i % squares + i / squares) % 2 == 0)
            painter.fillRect(
                QRectF(cell.left() + i % squares * square, cell.top() + i / squares * square, square, square),
                QColor(255, 255, 255, 34));
    }
    painter.setPen(QPen(QColor(20, 22, 26, 170), std::max(1.0, side / 64)));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(cell);

    QFont font;
    font.setBold(true);
    font.setPixelSize(100);
    QPainterPath letters;
    letters.addText(0, 0, font, name);
    // Every name gets the same height, long ones are narrowed to the cell.
    const QRectF box = letters.boundingRect();
    const double height = 0.4 * side / box.height(), width = std::min(height, 0.8 * side / box.width());
    QTransform place;
    place.translate(cell.center().x(), cell.top() + 0.68 * side);
    place.scale(width, height);
    place.translate(-box.center().x(), -box.center().y());
    drawShape(painter, place.map(letters), side / 24);
    drawShape(
        painter,
        arrowUp(QRectF(cell.center().x() - 0.13 * side, cell.top() + 0.1 * side, 0.26 * side, 0.3 * side)),
        side / 24);
}

} // namespace

QString letteredCellName(int column, int row)
{
    return QChar(u'A' + row) + QString::number(column + 1);
}

QImage letteredPattern(int cells)
{
    cells = std::clamp(cells, leastLetteredCells, mostLetteredCells);
    const int side = 2048 / cells * cells; // whole pixels per cell
    QImage image(side, side, QImage::Format_RGBA8888);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double cell = static_cast<double>(side) / cells;
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column)
            drawCell(painter, QRectF(column * cell, (cells - 1 - row) * cell, cell, cell),
                     cellColor(column, row, cells), letteredCellName(column, row));
    }
    return image;
}

} // namespace autocuts
