#include "views/tools/tooldrawing.h"

#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/tools/brush.h"

#include <QPainter>

namespace autocuts {

namespace {

//! True when the triangle is seen from behind; never in the map.
bool facesAway(const ToolCanvas &canvas, int triangle)
{
    if (canvas.kind() == ToolCanvas::Kind::Map)
        return false;
    const auto a = canvas.screenOf(3 * triangle), b = canvas.screenOf(3 * triangle + 1),
               c = canvas.screenOf(3 * triangle + 2);
    if (!a || !b || !c)
        return true;
    // The y axis of the screen points down.
    return (b->x() - a->x()) * (c->y() - a->y()) - (b->y() - a->y()) * (c->x() - a->x()) >= 0;
}

} // namespace

void drawEdges(QPainter &painter, const ToolCanvas &canvas, std::span<const int> edges, const QColor &color)
{
    QColor faint = color;
    faint.setAlphaF(0.35f);
    const QPen front(color, 4, Qt::SolidLine, Qt::RoundCap), behind(faint, 2, Qt::SolidLine, Qt::RoundCap);
    for (int edge : edges) {
        const auto &sides = canvas.content().topology().edgeSides[edge];
        const bool away =
            facesAway(canvas, sides[0] / 3) && (sides[1] < 0 || facesAway(canvas, sides[1] / 3));
        painter.setPen(away ? behind : front);
        for (int side : sides) {
            if (side < 0)
                continue;
            const auto from = canvas.screenOf(side), to = canvas.screenOf(nextSoupCorner(side));
            if (from && to)
                painter.drawLine(*from, *to);
            if (canvas.kind() == ToolCanvas::Kind::Model)
                break; // both sides are in the same position
        }
    }
}

void drawBrush(QPainter &painter, const ToolCanvas &canvas, const QPointF &centre, const Brush &brush,
               const QColor &color, double opacity)
{
    QColor fill = color;
    fill.setAlphaF(static_cast<float>(opacity));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(canvas.content().colors().dark ? Qt::black : Qt::white, 3.5)); // on any background
    painter.drawEllipse(centre, brush.radius, brush.radius);
    painter.setBrush(fill);
    painter.setPen(QPen(color, 1.8));
    painter.drawEllipse(centre, brush.radius, brush.radius);
    if (brush.hardness > 0) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(color, 1, Qt::DotLine));
        painter.drawEllipse(centre, brush.hardness * brush.radius, brush.hardness * brush.radius);
    }
}

void drawNote(QPainter &painter, const ToolCanvas &canvas, const QString &text)
{
    constexpr int fromTop = 28; // below the ruler of the UV view
    const ViewColors &colors = canvas.content().colors();
    const QFontMetrics metrics = painter.fontMetrics();
    const QString shown = metrics.elidedText(text, Qt::ElideRight, std::max(canvas.width() - 24, 0));
    QRect box(0, 0, metrics.horizontalAdvance(shown) + 20, metrics.height() + 10);
    box.moveCenter({canvas.width() / 2, fromTop + box.height() / 2});
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.panel);
    painter.drawRoundedRect(box, 5, 5);
    painter.setPen(colors.text);
    painter.drawText(box, Qt::AlignCenter, shown);
}

} // namespace autocuts
