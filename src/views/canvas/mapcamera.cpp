#include "views/canvas/mapcamera.h"

#include <algorithm>

namespace autocuts {

void MapCamera::setViewSize(const QSizeF &size)
{
    mSize = QSizeF(std::max(size.width(), 1.0), std::max(size.height(), 1.0));
}

void MapCamera::setCentre(const Vec2 &centre)
{
    constexpr double farthest = 1e6; // farther away, the UVs of neighbouring pixels would be equal
    mCentre = centre.cwiseMax(-farthest).cwiseMin(farthest);
}

void MapCamera::setScale(double scale)
{
    mScale = std::clamp(scale, minScale, maxScale);
}

void MapCamera::pan(const QPointF &pixels)
{
    setCentre(mCentre + Vec2(-pixels.x(), pixels.y()) / mScale);
}

void MapCamera::zoom(double factor, const QPointF &pixel)
{
    const Vec2 fixed = toUv(pixel);
    setScale(mScale * factor);
    setCentre(mCentre + fixed - toUv(pixel));
}

void MapCamera::frame(const Eigen::AlignedBox2d &box, const QMarginsF &covered)
{
    if (box.isEmpty())
        return;
    const Vec2 size = box.sizes().cwiseMax(1e-6);
    const QSizeF free = mSize.shrunkBy(covered);
    setScale(0.86 * std::min(free.width() / size.x(), free.height() / size.y()));
    const Vec2 shift(covered.right() - covered.left(), covered.top() - covered.bottom());
    setCentre(box.center() + 0.5 / mScale * shift);
}

Vec2 MapCamera::toUv(const QPointF &pixel) const
{
    return mCentre + Vec2(pixel.x() - 0.5 * mSize.width(), 0.5 * mSize.height() - pixel.y()) / mScale;
}

QPointF MapCamera::toScreen(const Vec2 &uv) const
{
    const Vec2 offset = (uv - mCentre) * mScale;
    return {0.5 * mSize.width() + offset.x(), 0.5 * mSize.height() - offset.y()};
}

} // namespace autocuts
