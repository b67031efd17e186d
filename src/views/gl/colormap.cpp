#include "views/gl/colormap.h"

#include "model/plain/texelweights.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace autocuts {

namespace {

// The colours are evenly spaced.
// Brown and teal differ for all common kinds of colour blindness, and no line or mark has these colours.
constexpr QRgb signedStops[] = {0xff6b3d0a, 0xffb07a2e, 0xffe3cb98, 0xfff5f5f2,
                                0xffa5d8cf, 0xff3d9e93, 0xff05554d};
constexpr QRgb magnitudeStops[] = {0xff2443c4, 0xff2f8fe0, 0xff4cc4b8, 0xff9fd66a,
                                   0xfff2d14b, 0xfff08a35, 0xffc41f1f};
// Lightness increases monotonically.
constexpr QRgb magnitudeBlindStops[] = {0xff42145c, 0xff45347f, 0xff365c8c, 0xff247e8c,
                                        0xff28a080, 0xff78c552, 0xfffae433};

//! Place in the gradient of densities of those that are too dense; chosen by hand.
constexpr double bandValue = 0.7;

std::span<const QRgb> stopsOf(HeatMap map, bool colorBlind)
{
    if (map != HeatMap::Magnitude)
        return signedStops;
    return colorBlind ? std::span<const QRgb>(magnitudeBlindStops) : std::span<const QRgb>(magnitudeStops);
}

} // namespace

QRgb mixColors(QRgb from, QRgb to, double amount)
{
    const auto mixed = [amount](int a, int b) { return static_cast<int>(std::lround(a + amount * (b - a))); };
    return qRgb(mixed(qRed(from), qRed(to)), mixed(qGreen(from), qGreen(to)), mixed(qBlue(from), qBlue(to)));
}

QRgb heatColor(HeatMap map, bool colorBlind, double value)
{
    if (std::isnan(value))
        return heatColorOfNothing();
    const std::span<const QRgb> stops = stopsOf(map, colorBlind);
    const double share = std::clamp(map == HeatMap::Magnitude ? value : 0.5 * (value + 1), 0.0, 1.0);
    const double place = share * static_cast<double>(stops.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    return mixColors(stops[below], stops[below + 1], place - static_cast<double>(below));
}

QRgb heatColorOfNothing()
{
    return 0xff6e6e6e;
}

QGradientStops heatStops(HeatMap map, bool colorBlind)
{
    const std::span<const QRgb> stops = stopsOf(map, colorBlind);
    QGradientStops result;
    for (std::size_t i = 0; i < stops.size(); ++i)
        result << QGradientStop(static_cast<double>(i) / static_cast<double>(stops.size() - 1),
                                QColor(stops[i]));
    return result;
}

double bandedDensity(double ratio, double tolerance)
{
    return ratio > 1 + tolerance ? bandValue : ratio < 1 - tolerance ? -bandValue : 0;
}

QGradientStops bandedDensityStops()
{
    const auto color = [](double value) { return QColor(heatColor(HeatMap::Density, false, value)); };
    return {{0, color(-bandValue)}, {0.333, color(-bandValue)}, {0.334, color(0)},
            {0.666, color(0)},      {0.667, color(bandValue)},  {1, color(bandValue)}};
}

QRgb texelWeightColor(double weight)
{
    return heatColor(HeatMap::Density, false, std::log2(weight) / std::log2(maxTexelWeight));
}

QRgb paintColor(double weight, QRgb neutral)
{
    constexpr QRgb keepTogether = 0xff37b24d, attractCuts = 0xff2f7bff;
    if (weight > 1) // the full colour is reached at a factor of 100
        return mixColors(neutral, keepTogether, std::min(1.0, 0.25 + 0.375 * std::log10(weight)));
    if (weight < 1)
        return mixColors(neutral, attractCuts, std::min(1.0, 0.25 + 0.75 * (1 - weight)));
    return neutral;
}

} // namespace autocuts
