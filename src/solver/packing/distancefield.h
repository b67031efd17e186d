// Signed distance to an island, sampled on a grid in the island's own coordinates.
#pragma once

#include "solver/packing/layout.h"
#include "solver/packing/workmeter.h"

namespace autocuts {

//! Distance to the outline, negative inside (winding number not zero); bilinear between the nodes.
class DistanceField
{
public:
    //! \param cell distance of two nodes, outline units; made larger when the grid would be too fine
    //! \param reach how far the grid goes beyond the outline's box
    DistanceField(const Outline &outline, double cell, double reach, WorkMeter &work);

    //! Distance at p; a large number off the grid.
    double at(const Vec2 &p) const
    {
        const double x = (p.x() - mLower.x()) * mInverse, y = (p.y() - mLower.y()) * mInverse;
        if (!(x >= 0 && y >= 0 && x < mColumns - 1 && y < mRows - 1))
            return far;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        const double u = x - i, v = y - j;
        const float *d = mDistance.data() + static_cast<std::size_t>(j) * mColumns + i;
        return (1 - v) * ((1 - u) * d[0] + u * d[1]) + v * ((1 - u) * d[mColumns] + u * d[mColumns + 1]);
    }
    //! Gradient of at(); zero off the grid.
    Vec2 gradientAt(const Vec2 &p) const;
    //! A lower bound of the distance that also holds off the grid.
    double lowerBoundAt(const Vec2 &p) const;

    static constexpr double far = 1e30;

private:
    void findNearestEdges(const Outline &outline, WorkMeter &work);
    void findSigns(const Outline &outline, WorkMeter &work);

    Vec2 mLower = Vec2::Zero(), mBoxLower = Vec2::Zero(), mBoxUpper = Vec2::Zero();
    double mCell = 1, mInverse = 1;
    int mColumns = 0, mRows = 0;
    std::vector<float> mDistance;
};

} // namespace autocuts
