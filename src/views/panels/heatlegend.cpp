#include "views/panels/heatlegend.h"

#include <QPainter>

namespace autocuts {

namespace {

constexpr int barHeight = 12, gap = 2;

} // namespace

HeatLegend::HeatLegend(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void HeatLegend::setLegend(const QGradientStops &stops, const std::array<QString, 3> &labels)
{
    mStops = stops;
    mLabels = labels;
    setAccessibleName(tr("Legend from %1 to %2").arg(labels.front(), labels.back()));
    update();
}

QSize HeatLegend::sizeHint() const
{
    return {140, barHeight + gap + fontMetrics().height()};
}

void HeatLegend::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QRectF bar = QRectF(0, 0, width(), barHeight).adjusted(0.5, 0.5, -0.5, -0.5);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    gradient.setStops(mStops);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(gradient);
    painter.drawRect(bar);
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    const QRect below(0, barHeight + gap, width(), fontMetrics().height());
    painter.drawText(below, Qt::AlignLeft, mLabels[0]);
    painter.drawText(below, Qt::AlignHCenter, mLabels[1]);
    painter.drawText(below, Qt::AlignRight, mLabels[2]);
}

} // namespace autocuts
