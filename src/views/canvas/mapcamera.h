// The camera of the UV view.
#pragma once

#include "model/plain/types.h"

#include <Eigen/Geometry>
#include <QMarginsF>
#include <QPointF>
#include <QSizeF>

namespace autocuts {

//! Shows a part of texture space, with v pointing up. Screen coordinates are logical pixels from the upper
//! left.
class MapCamera final
{
public:
    static constexpr double minScale = 1, maxScale = 1e6;

    void setViewSize(const QSizeF &size);
    const QSizeF &viewSize() const { return mSize; }

    //! The UV at the centre of the view.
    const Vec2 &centre() const { return mCentre; }
    void setCentre(const Vec2 &centre);
    //! Pixels per unit of texture space.
    double scale() const { return mScale; }
    void setScale(double scale);

    void pan(const QPointF &pixels);
    //! Zooms around a pixel. \param factor above 1 zooms in
    void zoom(double factor, const QPointF &pixel);
    //! Shows a box with a margin around it. \param covered what lies over the sides of the view
    void frame(const Eigen::AlignedBox2d &box, const QMarginsF &covered = {});

    Vec2 toUv(const QPointF &pixel) const;
    QPointF toScreen(const Vec2 &uv) const;

private:
    Vec2 mCentre = Vec2(0.5, 0.5);
    double mScale = 400;
    QSizeF mSize{100, 100};
};

} // namespace autocuts
