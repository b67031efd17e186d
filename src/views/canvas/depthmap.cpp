#include "views/canvas/depthmap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

constexpr int maxSize = 8192;

} // namespace

DepthMap::DepthMap(const QRectF &box)
    : mLeft(static_cast<int>(std::floor(box.left())) - 1), mTop(static_cast<int>(std::floor(box.top())) - 1),
      mWidth(std::clamp(static_cast<int>(std::ceil(box.width())) + 3, 1, maxSize)),
      mHeight(std::clamp(static_cast<int>(std::ceil(box.height())) + 3, 1, maxSize)),
      mNearness(static_cast<std::size_t>(mWidth) * mHeight, -std::numeric_limits<float>::infinity()),
      mSlope(mNearness.size(), 0)
{}

void DepthMap::add(const std::array<ScreenPoint, 3> &triangle, bool perspective)
{
    mPerspective = perspective;
    const auto &[a, b, c] = triangle;
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0)
        return;
    // Pixels are sampled at their centres.
    const double x0 = mLeft + 0.5, y0 = mTop + 0.5;
    const int firstRow =
        std::max(0, static_cast<int>(std::ceil(std::max(std::min({a.y, b.y, c.y}) - y0, 0.0))));
    const int lastRow = static_cast<int>(std::floor(std::min(std::max({a.y, b.y, c.y}) - y0, mHeight - 1.0)));
    const double na = nearness(a.depth), nb = nearness(b.depth), nc = nearness(c.depth);
    const double slopeX = ((nb - na) * (c.y - a.y) - (nc - na) * (b.y - a.y)) / area;
    const double slopeY = ((nc - na) * (b.x - a.x) - (nb - na) * (c.x - a.x)) / area;
    const float slope = static_cast<float>(std::abs(slopeX) + std::abs(slopeY));
    for (int row = firstRow; row <= lastRow; ++row) {
        const double y = y0 + row;
        double from = std::numeric_limits<double>::infinity(), to = -from;
        for (int k = 0; k < 3; ++k) {
            const ScreenPoint &p = triangle[k], &q = triangle[(k + 1) % 3];
            if ((p.y > y) == (q.y > y))
                continue;
            const double x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
            from = std::min(from, x);
            to = std::max(to, x);
        }
        const int firstColumn = static_cast<int>(std::ceil(std::clamp(from - x0, 0.0, mWidth * 1.0)));
        const int lastColumn = static_cast<int>(std::floor(std::clamp(to - x0, -1.0, mWidth - 1.0)));
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const auto value = static_cast<float>(na + slopeX * (x0 + column - a.x) + slopeY * (y - a.y));
            const std::size_t index = static_cast<std::size_t>(row) * mWidth + column;
            if (value > mNearness[index]) {
                mNearness[index] = value;
                mSlope[index] = slope;
            }
        }
    }
}

bool DepthMap::isVisible(const ScreenPoint &point) const
{
    const int column = static_cast<int>(std::floor(point.x - 0.5)) - mLeft;
    const int row = static_cast<int>(std::floor(point.y - 0.5)) - mTop;
    if (column < 0 || row < 0 || column >= mWidth - 1 || row >= mHeight - 1)
        return true;
    const double own = nearness(point.depth);
    // A point on an edge or silhouette is visible when at least one of the four samples around it does not
    // cover it.
    for (int dy = 0; dy <= 1; ++dy) {
        for (int dx = 0; dx <= 1; ++dx) {
            const std::size_t index = static_cast<std::size_t>(row + dy) * mWidth + column + dx;
            if (mNearness[index] <= own + 1e-4 * std::abs(own) + mSlope[index])
                return true;
        }
    }
    return false;
}

} // namespace autocuts
