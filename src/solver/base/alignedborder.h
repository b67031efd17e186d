// How much of a border can run along the axes.
#pragma once

#include "model/plain/types.h"
#include "solver/base/constant.h"
#include "solver/base/seamedmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace autocuts {

//! The length of border that runs along the axes when it is turned by 0, 1, ... 89 degrees.
class AlignedBorder
{
public:
    //! Adds a side. \param length how much it counts
    void add(const Vec2 &along, double length)
    {
        const double angle = std::atan2(along.y(), along.x()) * 180 / std::numbers::pi;
        const int middle = static_cast<int>(std::floor(angle)) + 3 * directions;
        for (int d = middle - nearAxis; d <= middle + nearAxis; ++d)
            mAligned[static_cast<std::size_t>(d % directions)] += length;
        mLength += length;
    }
    //! What is in this border and not in a part of it.
    AlignedBorder without(const AlignedBorder &part) const
    {
        AlignedBorder rest = *this;
        rest.mLength -= part.mLength;
        for (int d = 0; d < directions; ++d)
            rest.mAligned[d] -= part.mAligned[d];
        return rest;
    }
    double length() const { return mLength; }
    //! Length along the axes at the best angle.
    double most() const { return *std::max_element(mAligned.begin(), mAligned.end()); }

private:
    static constexpr int directions = 90; //!< a right angle by degrees
    static constexpr int nearAxis = 8;    //!< degrees within which a side counts as aligned; chosen by hand

    std::array<double, directions> mAligned{};
    double mLength = 0;
};

//! Length of border that does not run along the axes at its chart's best angle, on the model; what stands for
//! copies counts as often as there are copies. Only charts of components that are to be aligned count.
//! \param sides of the border: triangle sides 3 t + k \param chart per triangle \param x coordinates, see
//! Soup
double crookedBorder(const Soup &soup, const std::vector<bool> &aligned, const std::vector<int> &sides,
                     const std::vector<int> &chart, int chartCount, const std::vector<double> &x);

//! The cost of such border, solver units; 0 where islands need not run along the axes.
double crookedCost(const Soup &soup, const SeamedMap &map, const CutMesh &charts, const Snapshot &snapshot);

//! What a unit of its length costs, beside a seam that costs its length. Chosen by hand among 0, 0.1 and
//! 0.25. Measured in standard, 0 beside 0.25: a truck's seams 17.1 and 21.4 with .05 and .48 of its border
//! along the axes; wheels 12.0 and 12.0, .24 and .31; a bottle 5.4 and 4.8, .32 and .26; a gear does not
//! change.
inline AUTOCUTS_CONSTANT(double, alignmentCost, 0.25);

} // namespace autocuts
