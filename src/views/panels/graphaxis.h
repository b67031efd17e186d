// An axis of a graph: range, scale and ticks.
#pragma once

#include <QString>

#include <vector>

namespace autocuts {

//! Maps values to [0, 1]. Logarithmic when the largest value is more than 20 times the smallest, so that the
//! end of a solve stays readable beside its beginning; the factor was chosen by hand.
class GraphAxis
{
public:
    GraphAxis() = default;
    //! An axis for the values, with its ends rounded outwards to ticks; [0, 1] without values.
    //! \param values only finite ones count, and on a logarithmic axis only positive ones
    static GraphAxis around(const std::vector<float> &values);

    bool isLogarithmic() const { return mLogarithmic; }
    double minimum() const { return mMinimum; }
    double maximum() const { return mMaximum; }
    //! 0 at the minimum, 1 at the maximum; values outside are clamped.
    double fraction(double value) const;
    //! About `count` round values in the range, ascending.
    std::vector<double> ticks(int count) const;
    //! Short text for a tick.
    static QString label(double tick);

private:
    GraphAxis(double minimum, double maximum, bool logarithmic);

    double mMinimum = 0, mMaximum = 1;
    bool mLogarithmic = false;
};

} // namespace autocuts
