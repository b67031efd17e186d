#include "views/canvas/mapoverlays.h"

#include "model/document/document.h"
#include "model/plain/udimtiles.h"
#include "views/canvas/mapgrid.h"
#include "views/ui/icons.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

struct MapOverlays
{
    Q_DECLARE_TR_FUNCTIONS(MapOverlays)
};

//! The middle of the face that is nearest to the middle of an island's box. \returns texture space
Vec2 placeOn(const Document &document, int island)
{
    const MeshData &mesh = document.mesh();
    const Vec2 wanted = document.islands().box(island).center();
    Vec2 best = wanted;
    double distance = std::numeric_limits<double>::infinity();
    for (const int face : document.islands().faces(island)) {
        const int first = mesh.faceStart[face], count = mesh.faceStart[face + 1] - first;
        const Vec2 middle = document.uv().middleRows(first, count).colwise().mean().transpose();
        if ((middle - wanted).squaredNorm() < distance) {
            distance = (middle - wanted).squaredNorm();
            best = middle;
        }
    }
    return best;
}

bool allHidden(const Document &document, const std::vector<int> &faces)
{
    const std::vector<bool> &hidden = document.hidden();
    return !hidden.empty() &&
           std::all_of(faces.begin(), faces.end(), [&](int face) { return bool(hidden[face]); });
}

//! A mark on a ruler.
struct Mark
{
    double pixel = 0; //!< position along the ruler
    QString text;     //!< empty: a short mark
};

//! The marks of one ruler. \param axis 0: u along the upper side, 1: v along the left side
std::vector<Mark> rulerMarks(const QRect &view, const MapCamera &camera, int textureSize, int axis)
{
    const MapGrid grid = MapGrid::of(camera, textureSize);
    const double step = grid.step / grid.divisions;
    const Vec2 low = camera.toUv(view.bottomLeft()), high = camera.toUv(view.topRight());
    std::vector<Mark> marks;
    const double first = std::ceil(low[axis] / step), last = std::floor(high[axis] / step);
    for (double i = first; i <= last && marks.size() < 4096; ++i) {
        Vec2 place = low;
        place[axis] = i * step;
        const QPointF pixel = camera.toScreen(place);
        const bool labelled = std::fmod(i, grid.divisions) == 0;
        const double texels = i * step * textureSize;
        marks.push_back({axis == 0 ? pixel.x() : pixel.y(),
                         labelled ? QString::number(std::llround(texels)) : QString()});
    }
    return marks;
}

} // namespace

void drawTileNames(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera,
                   double tileHeight)
{
    constexpr double minTile = 70;
    if (camera.scale() * std::min(1.0, tileHeight) < minTile)
        return;
    const Vec2 tile(1, tileHeight);
    const Vec2 low = camera.toUv(view.bottomLeft()).cwiseQuotient(tile),
               high = camera.toUv(view.topRight()).cwiseQuotient(tile);
    constexpr int rows = (PackingSettings::lastTile - PackingSettings::firstTile) / 10;
    const QFontMetricsF metrics = painter.fontMetrics();
    painter.setPen(colors.dimText);
    for (int row = std::max(0, static_cast<int>(std::floor(std::min(low.y(), 1e6))));
         row <= std::min<double>(rows, high.y()); ++row) {
        for (int column = std::clamp(static_cast<int>(std::floor(low.x())), 0, 10);
             column < 10 && column <= high.x(); ++column) {
            const QPointF corner = camera.toScreen(Vec2(column, row).cwiseProduct(tile));
            const QString name = QString::number(PackingSettings::firstTile + column + 10 * row);
            const QRectF room(corner.x() + 3, corner.y() - metrics.height() - 5,
                              metrics.horizontalAdvance(name) + 6, metrics.height() + 2);
            if (!QRectF(view).contains(room))
                continue;
            painter.fillRect(room, colors.panel); // islands may lie below
            painter.drawText(room, Qt::AlignCenter, name);
        }
    }
}

void drawTilesInUse(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera,
                    double tileHeight, const std::vector<std::pair<int, QColor>> &tiles)
{
    constexpr double leastOutlined = 8, lineWidth = 1.4; // logical pixels
    const QRectF seen = QRectF(view).adjusted(-lineWidth, -lineWidth, lineWidth, lineWidth);
    const bool outlined = camera.scale() * std::min(1.0, tileHeight) >= leastOutlined;
    painter.setPen(outlined ? QPen(colors.text, lineWidth) : QPen(Qt::NoPen));
    for (const auto &[tile, color] : tiles) {
        const Eigen::AlignedBox2d box = udimTile(tile, tileHeight);
        const QRectF place = QRectF(camera.toScreen(box.min()), camera.toScreen(box.max())).normalized();
        if ((!outlined && !color.isValid()) || !seen.intersects(place))
            continue;
        painter.setBrush(color.isValid() ? QBrush(color) : QBrush(Qt::NoBrush));
        painter.drawRect(place);
    }
}

void drawRulers(QPainter &painter, const QRect &view, const ViewColors &colors, const MapCamera &camera,
                int textureSize)
{
    const QFont before = painter.font();
    QFont font = before;
    font.setPointSizeF(font.pointSizeF() * 0.8);
    painter.setFont(font);
    const QFontMetricsF metrics = painter.fontMetrics();
    painter.fillRect(QRect(view.left(), view.top(), view.width(), rulerSize), colors.panel);
    painter.fillRect(QRect(view.left(), view.top() + rulerSize, rulerSize, view.height() - rulerSize),
                     colors.panel);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    std::array<double, 2> lastText{-1e9, -1e9}; // per ruler: where the last number ends, in its direction
    const auto mark = [&](const Mark &m, bool horizontal) {
        const int place = static_cast<int>(std::lround(m.pixel));
        if (place < rulerSize)
            return;
        const int tip = m.text.isEmpty() ? rulerSize - 4 : rulerSize - 8;
        painter.setPen(colors.dimText);
        if (horizontal)
            painter.drawLine(place, tip, place, rulerSize - 1);
        else
            painter.drawLine(tip, place, rulerSize - 1, place);
        const double length = metrics.horizontalAdvance(m.text) + 3;
        if (m.text.isEmpty() || (horizontal ? place + length > view.right() : place - length < rulerSize))
            return;
        const double from = horizontal ? place : -place;
        if (from < lastText[horizontal])
            return; // numbers far from the origin are long
        lastText[horizontal] = from + length + 3;
        painter.setPen(colors.text);
        if (horizontal) {
            painter.drawText(QPointF(place + 3, rulerSize - 6), m.text);
        } else {
            painter.save();
            painter.translate(rulerSize - 6, place - 3);
            painter.rotate(-90);
            painter.drawText(QPointF(0, 0), m.text);
            painter.restore();
        }
    };
    for (const Mark &m : rulerMarks(view, camera, textureSize, 0))
        mark(m, true);
    for (const Mark &m : rulerMarks(view, camera, textureSize, 1))
        mark(m, false);
    painter.fillRect(QRect(view.left(), view.top(), rulerSize, rulerSize), colors.mapBackground);
    painter.restore();
    painter.setFont(before);
}

void drawIslandMarks(QPainter &painter, const QRect &view, const ViewColors &colors, const Document &document,
                     const MapCamera &camera, bool marks, bool numbers)
{
    constexpr double smallest = 14; // logical pixels of the longer side of an island
    const Islands &islands = document.islands();
    const QFontMetricsF metrics = painter.fontMetrics();
    for (int island = 0; island < islands.count(); ++island) {
        if (islands.box(island).sizes().maxCoeff() * camera.scale() < smallest ||
            allHidden(document, islands.faces(island)))
            continue;
        QStringList parts;
        if (numbers)
            parts << QString::number(island + 1);
        const IslandFlags flags = marks ? document.marks().flagsOf(islands.faces(island)) : IslandFlags();
        if (flags.group != 0)
            parts << MapOverlays::tr("G%1").arg(flags.group);
        if (flags.stack != 0)
            parts << MapOverlays::tr("S%1").arg(flags.stack);
        const QString text = parts.join(QLatin1Char(' '));
        QStringList icons;
        if (flags.locked != 0)
            icons << QStringLiteral("lock");
        if (flags.upright != 0)
            icons << QStringLiteral("upright");
        const double side = metrics.height(), room = side * static_cast<double>(icons.size());
        const QPointF middle =
            text.isEmpty() && icons.isEmpty() ? QPointF(-1, -1) : camera.toScreen(placeOn(document, island));
        if (!QRectF(view).contains(middle))
            continue;
        QRectF label(0, 0, metrics.horizontalAdvance(text) + room + 8, side + 2);
        label.moveCenter(middle);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors.panel);
        painter.drawRoundedRect(label, 3, 3);
        for (qsizetype i = 0; i < icons.size(); ++i) {
            const QRectF place(label.left() + 3 + side * static_cast<double>(i), label.top() + 1, side, side);
            icon(icons[i]).paint(&painter, place.toAlignedRect());
        }
        painter.setPen(colors.text);
        painter.drawText(label.adjusted(room, 0, 0, 0), Qt::AlignCenter, text);
    }
}

void drawOffTile(QPainter &painter, const ViewColors &colors, const Document &document,
                 const MapCamera &camera, const std::vector<std::pair<int, int>> &islands)
{
    const QFontMetricsF metrics = painter.fontMetrics();
    for (const auto &[island, tile] : islands) {
        const Eigen::AlignedBox2d &box = document.islands().box(island);
        const QRectF frame = QRectF(camera.toScreen(box.min()), camera.toScreen(box.max())).normalized();
        painter.setPen(QPen(colors.overlap, 1.6, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(frame.adjusted(-3, -3, 3, 3));
        const QString text = MapOverlays::tr("%1: of %2").arg(island + 1).arg(tile);
        const QRectF label(frame.left() - 3, frame.bottom() + 4, metrics.horizontalAdvance(text) + 6,
                           metrics.height() + 2);
        painter.fillRect(label, colors.panel);
        painter.setPen(colors.overlap);
        painter.drawText(label, Qt::AlignCenter, text);
    }
}

void drawCursor(QPainter &painter, const ViewColors &colors, const QPointF &place)
{
    constexpr double radius = 7, arm = 12; // logical pixels
    painter.setBrush(Qt::NoBrush);
    for (const auto &[color, width] : {std::pair(colors.panel, 3.0), std::pair(colors.text, 1.2)}) {
        painter.setPen(QPen(color, width));
        painter.drawEllipse(place, radius, radius);
        for (const QPointF &way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(place + 0.4 * radius * way, place + arm * way);
    }
}

void drawRectangles(QPainter &painter, const std::vector<LayoutRectangle> &rectangles,
                    const MapCamera &camera)
{
    for (const LayoutRectangle &rectangle : rectangles) {
        const QRectF box =
            QRectF(camera.toScreen(rectangle.lower), camera.toScreen(rectangle.upper)).normalized();
        const QColor color = QColor::fromRgb(rectangle.color);
        QColor fill = color;
        fill.setAlphaF(0.08f);
        painter.setPen(rectangle.hard ? QPen(color, 2.4) : QPen(color, 1.6, Qt::DashLine));
        painter.setBrush(fill);
        painter.drawRect(box);
        painter.setPen(color);
        const QString name = painter.fontMetrics().elidedText(
            rectangle.name, Qt::ElideRight, static_cast<int>(std::min(box.width(), 400.0)) - 8);
        painter.drawText(box.adjusted(5, 3, -3, -3), Qt::AlignTop | Qt::AlignLeft, name);
    }
}

} // namespace autocuts
