// A small depth buffer on the processor: which points of the model are hidden.
#pragma once

#include "views/canvas/orbitcamera.h"

#include <QRectF>

#include <array>
#include <vector>

namespace autocuts {

//! Depths of the front-most triangles, one sample per logical pixel of a rectangle of the view.
class DepthMap final
{
public:
    explicit DepthMap(const QRectF &box);

    void add(const std::array<ScreenPoint, 3> &triangle, bool perspective);
    //! False when another triangle is clearly before the point, all around it. Outside the rectangle: true.
    bool isVisible(const ScreenPoint &point) const;

private:
    //! 1 / depth in perspective, so that it is linear on the screen; else -depth. Larger is nearer.
    double nearness(double depth) const { return mPerspective ? 1 / depth : -depth; }

    int mLeft, mTop, mWidth, mHeight;
    bool mPerspective = true;
    std::vector<float> mNearness;
    std::vector<float> mSlope; //!< how much the nearness changes within a pixel there
};

} // namespace autocuts
