// A small depth buffer in main memory, to find out which points of the model are hidden.
#pragma once

#include "views/canvas/orbitcamera.h"

#include <QRectF>

#include <array>
#include <vector>

namespace autocuts {

//! The depths of the front-most triangles, one sample per logical pixel in a rectangle of the view.
class DepthMap final
{
public:
    explicit DepthMap(const QRectF &box);

    void add(const std::array<ScreenPoint, 3> &triangle, bool perspective);
    //! False when another triangle clearly covers the point and its surroundings. True outside the rectangle.
    bool isVisible(const ScreenPoint &point) const;

private:
    //! 1 / depth in perspective, which is linear on the screen; -depth otherwise. Larger values are nearer.
    double nearness(double depth) const { return mPerspective ? 1 / depth : -depth; }

    int mLeft, mTop, mWidth, mHeight;
    bool mPerspective = true;
    std::vector<float> mNearness;
    std::vector<float> mSlope; //!< change of the nearness within a pixel
};

} // namespace autocuts
