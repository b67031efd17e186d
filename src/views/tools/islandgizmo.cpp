#include "views/tools/islandgizmo.h"

#include "views/canvas/picking.h"

#include <QPainter>

#include <array>
#include <cmath>

namespace autocuts {

namespace {

constexpr double centreSize = 9; //!< half the side of the central square, in pixels

QPointF endOf(const QPointF &centre, DragAxis axis)
{
    return centre + (axis == DragAxis::X ? QPointF(gizmoLength, 0) : QPointF(0, -gizmoLength));
}

void drawHead(QPainter &painter, UvEdit edit, const QPointF &end, DragAxis axis)
{
    if (edit == UvEdit::Scale) {
        painter.drawRect(QRectF(end - QPointF(5, 5), QSizeF(10, 10)));
        return;
    }
    const QPointF along = axis == DragAxis::X ? QPointF(1, 0) : QPointF(0, -1);
    const QPointF across(-along.y(), along.x());
    const std::array corners{end + 9 * along, end - 4 * along + 6 * across, end - 4 * along - 6 * across};
    painter.drawConvexPolygon(corners.data(), static_cast<int>(corners.size()));
}

} // namespace

std::optional<DragAxis> gizmoPartAt(UvEdit edit, const QPointF &centre, const QPointF &mouse)
{
    const QPointF offset = mouse - centre;
    if (edit == UvEdit::Rotate) {
        const double distance = std::hypot(offset.x(), offset.y());
        return std::abs(distance - gizmoLength) < pickRadius ? std::optional(DragAxis::Both) : std::nullopt;
    }
    if (std::abs(offset.x()) <= centreSize + 2 && std::abs(offset.y()) <= centreSize + 2)
        return DragAxis::Both;
    for (DragAxis axis : {DragAxis::X, DragAxis::Y}) {
        const QPointF end = endOf(centre, axis);
        const SegmentPlace place =
            nearestOnSegment(mouse.x(), mouse.y(), centre.x(), centre.y(), end.x(), end.y());
        if (place.distance < pickRadius)
            return axis;
    }
    return std::nullopt;
}

void drawIslandGizmo(QPainter &painter, UvEdit edit, const QPointF &centre, std::optional<DragAxis> marked,
                     const ViewColors &colors)
{
    const auto colorOf = [&](DragAxis part) {
        return marked == part           ? colors.hover
               : part == DragAxis::Both ? colors.selection
                                        : colors.axes[part == DragAxis::X ? 0 : 1];
    };
    painter.save();
    painter.setBrush(Qt::NoBrush);
    const QColor middle = colorOf(DragAxis::Both);
    if (edit == UvEdit::Rotate) {
        painter.setPen(QPen(middle, 2.5));
        painter.drawEllipse(centre, gizmoLength, gizmoLength);
        painter.drawEllipse(centre, 2.5, 2.5);
        painter.restore();
        return;
    }
    for (DragAxis axis : {DragAxis::X, DragAxis::Y}) {
        const QColor color = colorOf(axis);
        painter.setPen(QPen(color, 2.5));
        painter.drawLine(centre, endOf(centre, axis));
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        drawHead(painter, edit, endOf(centre, axis), axis);
    }
    QColor fill = middle;
    fill.setAlphaF(0.35f);
    painter.setPen(QPen(middle, 1.5));
    painter.setBrush(fill);
    painter.drawRect(
        QRectF(centre - QPointF(centreSize, centreSize), QSizeF(2 * centreSize, 2 * centreSize)));
    painter.restore();
}

} // namespace autocuts
