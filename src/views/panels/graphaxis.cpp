#include "views/panels/graphaxis.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

constexpr double logarithmicRatio = 20;

//! The smallest number not below `length` that is 1, 2 or 5 times a power of ten.
double roundStep(double length)
{
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= length * (1 - 1e-9))
            return factor * power;
    }
    return 10 * power;
}

std::vector<double> logarithmicTicks(double minimum, double maximum, int count)
{
    std::vector<double> decades, all;
    for (int exponent = int(std::floor(std::log10(minimum))); exponent <= std::ceil(std::log10(maximum));
         ++exponent) {
        for (double factor : {1.0, 2.0, 5.0}) {
            const double tick = factor * std::pow(10.0, exponent);
            if (tick < minimum * (1 - 1e-9) || tick > maximum * (1 + 1e-9))
                continue;
            all.push_back(tick);
            if (factor == 1)
                decades.push_back(tick);
        }
    }
    const std::vector<double> &chosen =
        static_cast<int>(all.size()) <= count + 1 || decades.size() < 2 ? all : decades;
    const std::size_t stride = std::max<std::size_t>(1, (chosen.size() + count - 1) / count);
    std::vector<double> result;
    for (std::size_t i = 0; i < chosen.size(); i += stride)
        result.push_back(chosen[i]);
    return result;
}

} // namespace

GraphAxis::GraphAxis(double minimum, double maximum, bool logarithmic)
    : mMinimum(minimum), mMaximum(maximum), mLogarithmic(logarithmic)
{}

GraphAxis GraphAxis::around(const std::vector<float> &values)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (float value : values) {
        if (std::isfinite(value)) {
            low = std::min(low, double(value));
            high = std::max(high, double(value));
        }
    }
    if (!(low <= high))
        return {};
    if (low > 0 && high > logarithmicRatio * low)
        return {low, high, true};
    // Keeps small variations of a nearly constant curve from filling the whole height.
    const double span = std::max({high - low, 0.02 * std::abs(high), 1e-6});
    const double step = roundStep(span / 4);
    return {std::floor(low / step) * step, std::ceil((low + span) / step) * step, false};
}

double GraphAxis::fraction(double value) const
{
    const double fraction =
        mLogarithmic ? std::log(std::max(value, mMinimum) / mMinimum) / std::log(mMaximum / mMinimum)
                     : (value - mMinimum) / (mMaximum - mMinimum);
    return std::clamp(fraction, 0.0, 1.0);
}

std::vector<double> GraphAxis::ticks(int count) const
{
    if (mLogarithmic)
        return logarithmicTicks(mMinimum, mMaximum, count);
    const double step = roundStep((mMaximum - mMinimum) / count);
    std::vector<double> result;
    for (double i = std::ceil(mMinimum / step - 1e-6); i * step <= mMaximum + 1e-6 * step; ++i)
        result.push_back(i * step);
    return result;
}

QString GraphAxis::label(double tick)
{
    return std::abs(tick) < 1e-12 ? QStringLiteral("0") : QLocale().toString(tick, 'g', 4);
}

} // namespace autocuts
