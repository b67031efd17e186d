// The legend of a heat-map.
#pragma once

#include <QGradient>
#include <QWidget>

#include <array>

namespace autocuts {

//! A colour bar with a label at each end and one in the middle.
class HeatLegend final : public QWidget
{
    Q_OBJECT

public:
    explicit HeatLegend(QWidget *parent = nullptr);

    void setLegend(const QGradientStops &stops, const std::array<QString, 3> &labels);
    const std::array<QString, 3> &labels() const { return mLabels; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QGradientStops mStops;
    std::array<QString, 3> mLabels;
};

} // namespace autocuts
