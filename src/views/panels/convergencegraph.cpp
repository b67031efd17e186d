#include "views/panels/convergencegraph.h"

#include "views/ui/numbertext.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

constexpr double lineWidth = 1.5;
constexpr int tickSpacing = 30; //!< smallest distance of two ticks, in pixels

std::vector<float> valuesOf(const std::vector<live::TracePoint> &trace, float live::TracePoint::*field)
{
    std::vector<float> values;
    values.reserve(trace.size());
    for (const live::TracePoint &point : trace)
        values.push_back(point.*field);
    return values;
}

QColor mixed(const QColor &a, const QColor &b, double share)
{
    const auto mix = [share](double x, double y) { return float(x + (y - x) * share); };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

} // namespace

struct ConvergenceGraph::Colors
{
    QColor background, grid, text, delta, distortion, separation;
};

ConvergenceGraph::ConvergenceGraph(QWidget *parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
    setAccessibleName(tr("Convergence"));
    setToolTip(tr(
        "Distortion D (left axis) and separation S (right axis) of every iteration, or of every definite map "
        "that was found; the steps behind them are delta. Point at the graph, or use Left and Right, to "
        "read values."));
}

void ConvergenceGraph::setTrace(const std::vector<live::TracePoint> &trace)
{
    const live::TracePoint *before = marked();
    const int markedIteration = before ? before->iteration : -1;
    mTrace = trace;
    mDistortionAxis = GraphAxis::around(valuesOf(mTrace, &live::TracePoint::distortion));
    mSeparationAxis = GraphAxis::around(valuesOf(mTrace, &live::TracePoint::separation));
    mDeltaAxis = GraphAxis::around(valuesOf(mTrace, &live::TracePoint::delta));
    if (markedIteration >= 0) {
        const auto it = std::lower_bound(mTrace.begin(), mTrace.end(), markedIteration,
                                         [](const live::TracePoint &p, int i) { return p.iteration < i; });
        mMark = it == mTrace.end() ? int(mTrace.size()) - 1 : int(it - mTrace.begin());
    }
    update();
}

const live::TracePoint *ConvergenceGraph::marked() const
{
    return mMark >= 0 && mMark < static_cast<int>(mTrace.size()) ? &mTrace[mMark] : nullptr;
}

bool ConvergenceGraph::hasDelta() const
{
    return !mTrace.empty() && std::isfinite(mTrace.back().delta);
}

void ConvergenceGraph::setMark(int index)
{
    index = std::clamp(index, -1, static_cast<int>(mTrace.size()) - 1);
    if (index == mMark)
        return;
    mMark = index;
    update();
    Q_EMIT markChanged();
}

ConvergenceGraph::Colors ConvergenceGraph::colors() const
{
    const QColor base = palette().color(QPalette::Base);
    const QColor text = palette().color(QPalette::Text);
    const bool dark = base.lightnessF() < 0.5;
    Colors result;
    result.background = base;
    result.grid = mixed(base, text, 0.13);
    result.text = mixed(base, text, isEnabled() ? 0.7 : 0.4);
    result.delta = mixed(base, text, 0.09);
    result.distortion = dark ? QColor(0x62A8FF) : QColor(0x1B63C4);
    result.separation = dark ? QColor(0xFFA94D) : QColor(0xC25700);
    return result;
}

QRectF ConvergenceGraph::plotRect() const
{
    const QFontMetricsF metrics(font());
    const double side = metrics.horizontalAdvance(QStringLiteral("0.000")) + 6;
    // The values are written in their own line above the topmost tick.
    const double top = 1.5 * metrics.height() + 4;
    return QRectF(rect()).adjusted(side, top, -side, -metrics.height() - 4);
}

double ConvergenceGraph::xOf(int iteration, const QRectF &plot) const
{
    const double first = mTrace.front().iteration;
    const double span = std::max(1.0, mTrace.back().iteration - first);
    return plot.left() + plot.width() * (iteration - first) / span;
}

std::vector<ConvergenceGraph::Column> ConvergenceGraph::columns(float live::TracePoint::*field,
                                                                const QRectF &plot) const
{
    std::vector<Column> result;
    for (const live::TracePoint &point : mTrace) {
        const float value = point.*field;
        if (!std::isfinite(value))
            continue;
        const int x = static_cast<int>(std::lround(xOf(point.iteration, plot)));
        if (result.empty() || result.back().x != x)
            result.push_back({x, value, value, value});
        Column &column = result.back();
        column.low = std::min(column.low, value);
        column.high = std::max(column.high, value);
        column.last = value;
    }
    return result;
}

void ConvergenceGraph::paintEvent(QPaintEvent *)
{
    const Colors c = colors();
    QPainter painter(this);
    painter.fillRect(rect(), c.background);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF plot = plotRect();
    if (mTrace.empty()) {
        painter.setPen(c.text);
        painter.drawText(QRectF(rect()).adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Run the solver to see how it converges"));
        return;
    }
    if (hasDelta())
        drawDelta(painter, plot, c);
    drawFrame(painter, plot, c);
    drawCurve(painter, plot, &live::TracePoint::separation, mSeparationAxis, c.separation);
    drawCurve(painter, plot, &live::TracePoint::distortion, mDistortionAxis, c.distortion);
    if (marked())
        drawMark(painter, plot, c);
    else
        drawLegend(painter, plot, c);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void ConvergenceGraph::drawFrame(QPainter &painter, const QRectF &plot, const Colors &c) const
{
    const double height = painter.fontMetrics().height();
    const int tickCount = std::max(2, static_cast<int>(plot.height()) / tickSpacing);
    for (double tick : mDistortionAxis.ticks(tickCount)) {
        const double y = plot.bottom() - plot.height() * mDistortionAxis.fraction(tick);
        painter.setPen(QPen(c.grid, 1));
        painter.drawLine(QPointF(plot.left(), std::round(y) + 0.5),
                         QPointF(plot.right(), std::round(y) + 0.5));
        painter.setPen(c.distortion);
        painter.drawText(QRectF(0, y - height / 2, plot.left() - 4, height),
                         Qt::AlignRight | Qt::AlignVCenter, GraphAxis::label(tick));
    }
    painter.setPen(c.separation);
    for (double tick : mSeparationAxis.ticks(tickCount)) {
        const double y = plot.bottom() - plot.height() * mSeparationAxis.fraction(tick);
        painter.drawText(QRectF(plot.right() + 4, y - height / 2, width() - plot.right() - 4, height),
                         Qt::AlignLeft | Qt::AlignVCenter, GraphAxis::label(tick));
    }
    painter.setPen(c.text);
    const QRectF below(plot.left(), plot.bottom() + 3, plot.width(), height);
    painter.drawText(below, Qt::AlignLeft, countText(mTrace.front().iteration));
    painter.drawText(below, Qt::AlignHCenter, hasDelta() ? tr("iterations") : tr("maps"));
    painter.drawText(below, Qt::AlignRight, countText(mTrace.back().iteration));
}

void ConvergenceGraph::drawDelta(QPainter &painter, const QRectF &plot, const Colors &c) const
{
    // Delta is halved in steps, so it has its own logarithmic axis, with half the height.
    const auto yOf = [&](float delta) {
        return plot.bottom() - plot.height() * (0.05 + 0.9 * mDeltaAxis.fraction(delta));
    };
    QPainterPath path(plot.bottomLeft());
    double y = plot.bottom();
    for (const Column &column : columns(&live::TracePoint::delta, plot)) {
        path.lineTo(column.x, y);
        y = yOf(column.last);
        path.lineTo(column.x, y);
    }
    path.lineTo(plot.right(), y);
    path.lineTo(plot.bottomRight());
    painter.fillPath(path, c.delta);
}

void ConvergenceGraph::drawCurve(QPainter &painter, const QRectF &plot, float live::TracePoint::*field,
                                 const GraphAxis &axis, const QColor &color) const
{
    QPolygonF line;
    for (const Column &column : columns(field, plot)) {
        const auto add = [&](float value) {
            line.append(QPointF(column.x, plot.bottom() - plot.height() * axis.fraction(value)));
        };
        if (column.low != column.high) {
            add(column.low);
            add(column.high);
        }
        add(column.last);
    }
    painter.setPen(QPen(color, lineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (line.size() == 1)
        painter.drawPoint(line.front());
    else
        painter.drawPolyline(line);
}

void ConvergenceGraph::drawLegend(QPainter &painter, const QRectF &plot, const Colors &c) const
{
    const live::TracePoint &last = mTrace.back();
    const QRectF above(4, 2, width() - 8, painter.fontMetrics().height());
    painter.setPen(c.distortion);
    painter.drawText(above, Qt::AlignLeft, tr("D %1").arg(fixedText(last.distortion, 4)));
    painter.setPen(c.separation);
    painter.drawText(above, Qt::AlignRight, tr("S %1").arg(fixedText(last.separation, 3)));
    painter.setPen(c.text);
    if (hasDelta())
        painter.drawText(QRectF(plot.left(), 2, plot.width(), above.height()), Qt::AlignHCenter,
                         tr("δ %1").arg(significantText(last.delta, 3)));
}

void ConvergenceGraph::drawMark(QPainter &painter, const QRectF &plot, const Colors &c) const
{
    const live::TracePoint &point = *marked();
    const double x = xOf(point.iteration, plot);
    painter.setPen(QPen(c.text, 1, Qt::DashLine));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    const auto dot = [&](double fraction, const QColor &color) {
        painter.setPen(QPen(c.background, 1));
        painter.setBrush(color);
        painter.drawEllipse(QPointF(x, plot.bottom() - plot.height() * fraction), 3.5, 3.5);
    };
    dot(mSeparationAxis.fraction(point.separation), c.separation);
    dot(mDistortionAxis.fraction(point.distortion), c.distortion);

    const std::array<std::pair<QString, QColor>, 4> parts{{
        {tr("#%1").arg(point.iteration), c.text},
        {tr("D %1").arg(fixedText(point.distortion, 4)), c.distortion},
        {tr("S %1").arg(fixedText(point.separation, 3)), c.separation},
        {hasDelta() ? tr("δ %1").arg(significantText(point.delta, 3)) : QString(), c.text},
    }};
    const QFontMetricsF metrics(font());
    double total = 0;
    for (const auto &part : parts)
        total += metrics.horizontalAdvance(part.first);
    const double gap = std::max(4.0, (width() - 8 - total) / (parts.size() - 1));
    double left = 4;
    for (const auto &[text, color] : parts) {
        painter.setPen(color);
        painter.drawText(QPointF(left, 2 + metrics.ascent()), text);
        left += metrics.horizontalAdvance(text) + gap;
    }
}

bool ConvergenceGraph::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        // These keys are also shortcuts of the program.
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home || key == Qt::Key_End)
            event->accept();
    }
    return QWidget::event(event);
}

void ConvergenceGraph::mouseMoveEvent(QMouseEvent *event)
{
    if (mTrace.empty())
        return;
    const QRectF plot = plotRect();
    const double x = std::clamp(event->position().x(), plot.left(), plot.right());
    const auto nearest = std::min_element(
        mTrace.begin(), mTrace.end(), [&](const live::TracePoint &a, const live::TracePoint &b) {
            return std::abs(xOf(a.iteration, plot) - x) < std::abs(xOf(b.iteration, plot) - x);
        });
    setMark(static_cast<int>(nearest - mTrace.begin()));
}

void ConvergenceGraph::leaveEvent(QEvent *)
{
    setMark(-1);
}

void ConvergenceGraph::keyPressEvent(QKeyEvent *event)
{
    const int last = static_cast<int>(mTrace.size()) - 1;
    switch (event->key()) {
    case Qt::Key_Left:
        setMark(mMark < 0 ? last : std::max(0, mMark - 1));
        break;
    case Qt::Key_Right:
        setMark(mMark < 0 ? 0 : mMark + 1);
        break;
    case Qt::Key_Home:
        setMark(0);
        break;
    case Qt::Key_End:
        setMark(last);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void ConvergenceGraph::focusOutEvent(QFocusEvent *event)
{
    setMark(-1);
    QWidget::focusOutEvent(event);
}

} // namespace autocuts
