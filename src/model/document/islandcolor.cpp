#include "model/document/islandcolor.h"

#include <cmath>

namespace autocuts {

QRgb islandColor(int number)
{
    constexpr double goldenRatio = 0.6180339887498949;
    constexpr double firstHue = 0.08, hues = 0.82; // from orange to pink
    const double hue = firstHue + hues * std::fmod(0.61 + number * goldenRatio, 1.0);
    // Hues become similar again after 8, 13, ... numbers; the lightness has another period, so those differ.
    const double lightness = 0.56 + 0.07 * (number % 3 - 1);
    return QColor::fromHslF(static_cast<float>(hue), 0.52f, static_cast<float>(lightness)).rgb();
}

} // namespace autocuts
