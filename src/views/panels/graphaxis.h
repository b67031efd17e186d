// One axis of a graph: range, scale and ticks.
#pragma once

#include <QString>

#include <vector>

namespace autocuts {

//! Maps values to [0, 1]. Logarithmic when the values span more than a factor of 20, so that what happens
//! near the end of a solve is not crushed by its beginning.
class GraphAxis
{
public:
    GraphAxis() = default;
    //! Fits the range to values, rounded outwards to ticks; without values [0, 1].
    //! \param values finite ones count, and on a logarithmic axis positive ones
    static GraphAxis around(const std::vector<float> &values);

    bool isLogarithmic() const { return mLogarithmic; }
    double minimum() const { return mMinimum; }
    double maximum() const { return mMaximum; }
    //! 0 at the minimum, 1 at the maximum, limited to that.
    double fraction(double value) const;
    //! About `count` round values within the range, rising.
    std::vector<double> ticks(int count) const;
    //! Short text of a tick.
    static QString label(double tick);

private:
    GraphAxis(double minimum, double maximum, bool logarithmic);

    double mMinimum = 0, mMaximum = 1;
    bool mLogarithmic = false;
};

} // namespace autocuts
