#include "model/document/materialcolor.h"

#include "model/document/islandcolor.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! IEC 61966-2-1.
double toPicture(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

} // namespace

QRgb materialColor(double red, double green, double blue)
{
    if (!std::isfinite(red) || !std::isfinite(green) || !std::isfinite(blue))
        return 0;
    const auto byte = [](double share) {
        return static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    };
    return qRgb(byte(red), byte(green), byte(blue));
}

QRgb linearMaterialColor(double red, double green, double blue)
{
    return materialColor(toPicture(red), toPicture(green), toPicture(blue));
}

QRgb shownMaterialColor(const Scene &scene, int material)
{
    if (material < 0)
        return qRgb(128, 128, 128);
    const auto number = static_cast<std::size_t>(material);
    const QRgb color = number < scene.materialColors.size() ? scene.materialColors[number] : 0;
    return color != 0 ? color : islandColor(material);
}

} // namespace autocuts
