// Signed distance to an island's outline, sampled on a grid in the coordinates of the outline.
#pragma once

#include "solver/packing/layout.h"
#include "solver/packing/workmeter.h"

#include <algorithm>

namespace autocuts::packing {

//! Distance to the outline, negative inside (winding number not zero), interpolated bilinearly between nodes.
class DistanceField
{
public:
    //! \param cell spacing of the nodes, outline units; made larger when there would be more than 2^18 nodes
    //! \param reach how far the grid extends beyond the outline's box, outline units
    DistanceField(const Outline &outline, double cell, double reach, WorkMeter &work);

    //! Distance at (px, py), outline units; `far` outside the grid. Takes scalars because it is called
    //! millions of times.
    double at(double px, double py) const
    {
        const double x = (px - mLower.x()) * mInverse, y = (py - mLower.y()) * mInverse;
        if (!(x >= 0 && y >= 0 && x < mColumns - 1 && y < mRows - 1))
            return far;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        const float u = static_cast<float>(x - i), v = static_cast<float>(y - j);
        const float *d = mDistance.data() + static_cast<std::size_t>(j) * mColumns + i;
        const float below = d[0] + u * (d[1] - d[0]);
        const float above = d[mColumns] + u * (d[mColumns + 1] - d[mColumns]);
        return below + v * (above - below);
    }
    //! Gradient of at(); zero outside the grid.
    Vec2 gradientAt(const Vec2 &p) const;
    //! True when (px, py) is outside the outline by at least `limit`. Conservative: false when in doubt.
    bool isFartherThan(double px, double py, double limit) const
    {
        const double dx = std::max(0.0, std::max(mBoxLower.x() - px, px - mBoxUpper.x()));
        const double dy = std::max(0.0, std::max(mBoxLower.y() - py, py - mBoxUpper.y()));
        if (dx * dx + dy * dy >= limit * limit)
            return true;
        const double d = at(px, py);
        return d < far && d - mCell >= limit;
    }

    static constexpr double far = 1e30;

private:
    void findNearestEdges(const Outline &outline, WorkMeter &work);
    void findSigns(const Outline &outline, WorkMeter &work);

    Vec2 mLower = Vec2::Zero(), mBoxLower = Vec2::Zero(), mBoxUpper = Vec2::Zero();
    double mCell = 1, mInverse = 1;
    int mColumns = 0, mRows = 0;
    std::vector<float> mDistance;
};

} // namespace autocuts::packing
