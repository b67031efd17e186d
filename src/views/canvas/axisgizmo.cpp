#include "views/canvas/axisgizmo.h"

#include "views/gl/viewcolors.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>

namespace autocuts {

namespace {

// Logical pixels.
constexpr double axisLength = 28;
constexpr double positiveRadius = 8, negativeRadius = 5.5;

QPointF centreOf(const QRect &view)
{
    return {view.right() - 48.0, view.top() + 48.0};
}

int axisOf(ViewSide side)
{
    return static_cast<int>(side) / 2;
}

bool isPositive(ViewSide side)
{
    return static_cast<int>(side) % 2 == 0;
}

} // namespace

std::array<AxisEnd, 6> axisEnds(const QRect &view, const OrbitCamera &camera)
{
    std::array<AxisEnd, 6> ends;
    for (int i = 0; i < 6; ++i) {
        const auto side = static_cast<ViewSide>(i);
        const Vec3 direction = directionOf(side);
        ends[static_cast<std::size_t>(i)] = {
            side,
            centreOf(view) + axisLength * QPointF(direction.dot(camera.right()), -direction.dot(camera.up())),
            direction.dot(camera.forward())};
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const AxisEnd &a, const AxisEnd &b) { return a.depth > b.depth; });
    return ends;
}

std::optional<AxisEnd> axisEndAt(const QRect &view, const OrbitCamera &camera, const QPointF &pixel)
{
    const std::array<AxisEnd, 6> ends = axisEnds(view, camera);
    const auto hit = std::find_if(ends.rbegin(), ends.rend(), [&](const AxisEnd &end) {
        return QLineF(end.centre, pixel).length() <= positiveRadius + 1;
    });
    return hit == ends.rend() ? std::nullopt : std::optional(*hit);
}

void drawAxisGizmo(QPainter &painter, const QRect &view, const ViewColors &colors, const OrbitCamera &camera,
                   std::optional<ViewSide> hovered)
{
    painter.save();
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    font.setBold(true);
    painter.setFont(font);
    for (const AxisEnd &end : axisEnds(view, camera)) {
        const int axis = axisOf(end.side);
        QColor color = colors.axes[static_cast<std::size_t>(axis)];
        if (end.depth > 0.2)
            color.setAlphaF(0.55f);
        const double radius = isPositive(end.side) ? positiveRadius : negativeRadius;
        if (isPositive(end.side)) {
            painter.setPen(QPen(color, 2.2, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(centreOf(view), end.centre);
            painter.setBrush(color);
        } else {
            QColor faint = color;
            faint.setAlphaF(0.25f);
            painter.setBrush(faint);
        }
        painter.setPen(hovered == end.side ? QPen(colors.text, 1.6) : QPen(color, 1.2));
        painter.drawEllipse(end.centre, radius, radius);
        if (!isPositive(end.side))
            continue;
        painter.setPen(QColor(0x16, 0x18, 0x1a));
        painter.drawText(QRectF(end.centre - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter,
                         QString(QLatin1Char("XYZ"[axis])));
    }
    painter.restore();
}

} // namespace autocuts
